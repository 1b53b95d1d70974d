#pragma once

#include "renderer/math/color.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace rt::lang {

/// A named colour of CSS (CSS Color Module Level 4, section 6.1), sRGB as 0xrrggbb.
struct CssColor {
  std::string_view name;
  std::uint32_t rgb;
};

/// All of them, by name.
std::span<const CssColor> css_colors();
std::optional<std::uint32_t> find_css_color(std::string_view name);

/// 0xrrggbb to linear light.
Color from_srgb8(std::uint32_t rgb);

} // namespace rt::lang
