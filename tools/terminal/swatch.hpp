#pragma once

#include "renderer/math/color.hpp"

#include <string>
#include <string_view>

namespace rt::tools {

/// Two cells of the colour (linear light, clipped), for a terminal.
std::string swatch(const Color& color);

/// Dimmed, if colours are used.
std::string dim(std::string_view text, bool uses_color);

} // namespace rt::tools
