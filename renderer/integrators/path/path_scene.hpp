#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/compile/material_bindings.hpp"
#include "renderer/lighting/lamps.hpp"
#include "renderer/scattering/material_tables.hpp"

namespace rt {

/// What the path tracer needs of a scene, made once for all threads.
struct PathScene {
  /// The scene must outlive it.
  explicit PathScene(const CompiledScene& compiled)
      : scene(compiled), lamps(compiled), tables(compiled.bindings().materials()) {}

  const CompiledScene& scene;
  Lamps lamps;
  ScatteringTables tables;
};

} // namespace rt
