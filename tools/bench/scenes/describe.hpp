#pragma once

#include "renderer/scene/scene.hpp"
#include "tools/bench/scenes/layout.hpp"

namespace rt::tools::bench {

/// The scene as loading its text would describe it, up to the rounding of the numbers: for measuring the renderer
/// alone.
scene::Scene describe(const Layout& layout);

} // namespace rt::tools::bench
