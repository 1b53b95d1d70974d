#pragma once

#include "renderer/lighting/emitters.hpp"
#include "renderer/lighting/sized_lamps.hpp"

namespace rt {

/// All that emits light in a scene, except the environment.
struct Lamps {
  /// The scene must outlive them.
  explicit Lamps(const CompiledScene& scene) : emitters(scene), sized(scene.lights()) {
    for (const Light& lamp : scene.lights())
      if (!has_size(lamp)) sizeless.push_back(lamp);
  }

  Emitters emitters;           ///< shapes
  SizedLamps sized;            ///< spheres and suns that are visible
  std::vector<Light> sizeless; ///< which no path hits by chance
};

} // namespace rt
