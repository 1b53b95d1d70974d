#pragma once

#include "renderer/scene/scene.hpp"

namespace rt::scene {

/// Removes from the scene's tables what it does not use: shapes, materials, patterns and transforms of things that were
/// created but never placed. The order of the rest is preserved.
void compact(Scene& scene);

} // namespace rt::scene
