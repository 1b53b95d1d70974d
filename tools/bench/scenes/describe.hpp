#pragma once

#include "renderer/scene/scene.hpp"
#include "tools/bench/scenes/layout.hpp"

namespace rt::tools::bench {

/// The description that loading the scene's text would give, up to the rounding of numbers: for measuring the renderer
/// alone.
scene::Scene describe(const Layout& layout);

} // namespace rt::tools::bench
