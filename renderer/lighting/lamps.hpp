#pragma once

#include "renderer/lighting/emitters.hpp"
#include "renderer/lighting/sized_lamps.hpp"

namespace rt {

/// All that shines in a scene, but for what is seen where nothing is.
struct Lamps {
  /// The scene must outlive them.
  explicit Lamps(const CompiledScene& scene) : emitters(scene), sized(scene.lights()) {
    for (const Light& lamp : scene.lights())
      if (!has_size(lamp)) sizeless.push_back(lamp);
  }

  Emitters emitters;           ///< shapes
  SizedLamps sized;            ///< balls and suns that are seen
  std::vector<Light> sizeless; ///< which no path finds by chance
};

} // namespace rt
