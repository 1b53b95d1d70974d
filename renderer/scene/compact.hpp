#pragma once

#include "renderer/scene/scene.hpp"

namespace rt::scene {

/// Takes out of the scene's tables what stands nowhere in it: shapes, materials, patterns and turns of things that were
/// made and kept, but never placed. The order of the rest stays.
void compact(Scene& scene);

} // namespace rt::scene
