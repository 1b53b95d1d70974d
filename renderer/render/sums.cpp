#include "renderer/render/sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {
namespace {

constexpr double limit = 0x1p62;
constexpr auto upper_limit = std::int64_t{1} << 62;

} // namespace

void FixedSum::add(double number) {
  const double clipped = std::clamp(number, -limit, limit);
  const double whole = std::floor(clipped);
  const double rest = (clipped - whole) * 0x1p64; // an integer if it is above 2⁵²
  const auto fraction = static_cast<std::uint64_t>(rest < 0x1p52 ? rest + 0.5 : rest);
  add(from(static_cast<std::int64_t>(whole), fraction));
}

void FixedSum::add(const FixedSum& other) {
  lower_ += other.lower_;
  const std::int64_t carry = lower_ < other.lower_ ? 1 : 0;
  // Both are within ±2⁶², so that nothing overflows before saturation.
  upper_ += other.upper_ + carry;
  if (upper_ >= upper_limit) *this = from(upper_limit, 0);
  if (upper_ < -upper_limit) *this = from(-upper_limit, 0);
}

double FixedSum::value() const {
  return static_cast<double>(upper_) + static_cast<double>(lower_) * 0x1p-64;
}

void PixelSums::add(std::uint32_t sample, const Color& radiance) {
  auto& sums = sums_[sample % 2];
  sums[0].add(radiance.r);
  sums[1].add(radiance.g);
  sums[2].add(radiance.b);
  ++counts_[sample % 2];
}

void PixelSums::add(const PixelSums& other) {
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::size_t channel = 0; channel < 3; ++channel) sums_[half][channel].add(other.sums_[half][channel]);
    counts_[half] += other.counts_[half];
  }
}

Color PixelSums::mean() const {
  if (samples() == 0) return black;
  const auto channel = [&](std::size_t i) {
    FixedSum both = sums_[0][i];
    both.add(sums_[1][i]);
    return both.value() / samples();
  };
  return {channel(0), channel(1), channel(2)};
}

Color PixelSums::mean(std::size_t half) const {
  const auto channel = [&](std::size_t i) { return sums_[half][i].value() / counts_[half]; };
  return {channel(0), channel(1), channel(2)};
}

Color PixelSums::error() const {
  if (counts_[0] == 0 || counts_[1] == 0) return grey(std::numeric_limits<double>::infinity());
  const Color difference = mean(0) - mean(1);
  return {std::abs(difference.r) / 2, std::abs(difference.g) / 2, std::abs(difference.b) / 2};
}

} // namespace rt
