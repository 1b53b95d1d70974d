#include "renderer/render/noise_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {
namespace {

constexpr int calm_passes = 2; // a single one favours blocks that were lucky

// Newton's method: products and quotients only, which are the same on every machine. For x between 0 and 1.
double cube_root(double x) {
  double root = 1;
  for (int i = 0; i < 60; ++i) root = (2 * root + x / (root * root)) / 3;
  return root;
}

// The slope of sRGB's encoding (IEC 61966-2-1): 12.92, or 1.055/2.4 · L^(−7/12).
double display_slope(double light) {
  constexpr double steep = 1.055 / 2.4;
  if (light >= 1) return steep / light;
  if (light <= 0.0031308) return 12.92;
  const double twelfth = std::sqrt(std::sqrt(cube_root(light)));
  const double cubed = twelfth * twelfth * twelfth;
  return steep / (cubed * cubed * twelfth);
}

double squared(double x) {
  return x * x;
}

} // namespace

NoiseBlocks::NoiseBlocks(const PixelRect& rect, double aim)
    : rect_(rect), aim_(aim), first_column_(rect.x0 / side), first_row_(rect.y0 / side),
      columns_((rect.x1 - 1) / side - first_column_ + 1), rows_((rect.y1 - 1) / side - first_row_ + 1) {
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  noise_.assign(count, std::numeric_limits<double>::infinity());
  calm_.assign(count, 0);
  rests_.assign(count, false);
}

void NoiseBlocks::update(std::span<const PixelSums> sums) {
  std::vector<Color> means;
  means.reserve(sums.size());
  for (const PixelSums& pixel : sums) means.push_back(pixel.mean());
  for (int row = first_row_; row < first_row_ + rows_; ++row) {
    for (int column = first_column_; column < first_column_ + columns_; ++column) {
      const std::size_t i = index(column, row);
      if (!rests_[i]) noise_[i] = noise(column, row, sums, means);
      calm_[i] = rests_[i] || noise_[i] <= aim_ ? calm_[i] + 1 : 0;
    }
  }
  if (aim_ > 0) settle();
}

std::uint32_t NoiseBlocks::state(int x, int y) const {
  const std::size_t i = index(x / side, y / side);
  return 2 * static_cast<std::uint32_t>(calm_[i]) + (rests_[i] ? 1 : 0);
}

void NoiseBlocks::restore(std::span<const std::uint32_t> states, std::span<const PixelSums> sums) {
  update(sums);
  for (int y = rect_.y0; y < rect_.y1; ++y) {
    for (int x = rect_.x0; x < rect_.x1; ++x) {
      const std::uint32_t state = states[pixel(x, y)];
      calm_[index(x / side, y / side)] = static_cast<int>(state / 2);
      rests_[index(x / side, y / side)] = state % 2 == 1;
    }
  }
}

void NoiseBlocks::settle() {
  for (int row = first_row_; row < first_row_ + rows_; ++row)
    for (int column = first_column_; column < first_column_ + columns_; ++column)
      if (is_surrounded_by_calm(column, row)) rests_[index(column, row)] = true;
}

bool NoiseBlocks::is_surrounded_by_calm(int column, int row) const {
  for (int y = std::max(row - 1, first_row_); y <= std::min(row + 1, first_row_ + rows_ - 1); ++y)
    for (int x = std::max(column - 1, first_column_); x <= std::min(column + 1, first_column_ + columns_ - 1); ++x)
      if (calm_[index(x, y)] < calm_passes) return false;
  return true;
}

Color NoiseBlocks::light_around(int x, int y, std::span<const Color> means) const {
  Color sum = black;
  int count = 0;
  for (int v = std::max(y - 1, rect_.y0); v <= std::min(y + 1, rect_.y1 - 1); ++v) {
    for (int u = std::max(x - 1, rect_.x0); u <= std::min(x + 1, rect_.x1 - 1); ++u, ++count) sum += means[pixel(u, v)];
  }
  return sum * (1.0 / count);
}

double NoiseBlocks::noise(int column, int row, std::span<const PixelSums> sums, std::span<const Color> means) const {
  double sum = 0;
  int count = 0;
  for (int y = std::max(row * side, rect_.y0); y < std::min((row + 1) * side, rect_.y1); ++y) {
    for (int x = std::max(column * side, rect_.x0); x < std::min((column + 1) * side, rect_.x1); ++x, ++count) {
      const Color light = light_around(x, y, means);
      const Color error = sums[pixel(x, y)].error();
      sum += squared(display_slope(light.r) * error.r) + squared(display_slope(light.g) * error.g) +
             squared(display_slope(light.b) * error.b);
    }
  }
  return std::sqrt(sum / (3.0 * count));
}

bool NoiseBlocks::all_rest() const {
  return std::all_of(rests_.begin(), rests_.end(), [](bool rests) { return rests; });
}

double NoiseBlocks::worst() const {
  return *std::max_element(noise_.begin(), noise_.end());
}

} // namespace rt
