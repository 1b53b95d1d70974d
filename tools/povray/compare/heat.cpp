#include "tools/povray/compare/heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::tools {
namespace {

// One colour for each power of ten from 1e-8 to 1, in sRGB.
constexpr std::array<std::array<double, 3>, 9> steps{{{0.05, 0.05, 0.25},
                                                      {0.13, 0.07, 0.42},
                                                      {0.32, 0.07, 0.48},
                                                      {0.52, 0.13, 0.45},
                                                      {0.72, 0.20, 0.36},
                                                      {0.88, 0.34, 0.21},
                                                      {0.97, 0.55, 0.10},
                                                      {0.98, 0.80, 0.22},
                                                      {1.00, 1.00, 0.90}}};

} // namespace

Rgb32 heat(double error) {
  if (!(error > 0)) return std::isnan(error) ? heat(1) : Rgb32{};
  const double position = std::clamp(std::log10(error) + 8, 0.0, 8.0);
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(position), 7);
  const double share = position - static_cast<double>(below);
  const auto channel = [&](std::size_t c) {
    return static_cast<float>(srgb_to_linear(steps[below][c] * (1 - share) + steps[below + 1][c] * share));
  };
  return {channel(0), channel(1), channel(2)};
}

Film film_of(std::vector<Rgb32> color, int width, int height) {
  Film film;
  film.width = width;
  film.height = height;
  film.color = std::move(color);
  return film;
}

Film heat_map(const std::vector<float>& errors, int width, int height) {
  std::vector<Rgb32> color(errors.size());
  std::transform(errors.begin(), errors.end(), color.begin(), [](float e) { return heat(e); });
  return film_of(std::move(color), width, height);
}

} // namespace rt::tools
