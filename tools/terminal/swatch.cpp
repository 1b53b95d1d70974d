#include "tools/terminal/swatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rt::tools {
namespace {

int to_byte(double linear) {
  return static_cast<int>(std::lround(linear_to_srgb(std::clamp(linear, 0.0, 1.0)) * 255));
}

bool has_direct_colors() {
  const char* value = std::getenv("COLORTERM");
  return value && (std::string_view(value) == "truecolor" || std::string_view(value) == "24bit");
}

// The nearest of the 6 × 6 × 6 colours that all 256-colour terminals have; their levels are 0, 95, 135, … 255.
int to_cube(int byte) {
  return byte < 48 ? 0 : byte < 115 ? 1 : (byte - 35) / 40;
}

} // namespace

std::string swatch(const Color& color) {
  const int r = to_byte(color.r), g = to_byte(color.g), b = to_byte(color.b);
  if (has_direct_colors()) return fmt::format("\x1b[48;2;{};{};{}m  \x1b[0m", r, g, b);
  return fmt::format("\x1b[48;5;{}m  \x1b[0m", 16 + 36 * to_cube(r) + 6 * to_cube(g) + to_cube(b));
}

std::string dim(std::string_view text, bool uses_color) {
  return uses_color ? fmt::format("\x1b[2m{}\x1b[0m", text) : std::string(text);
}

} // namespace rt::tools
