#include "renderer/image/quantise.hpp"

#include "renderer/math/color.hpp"

#include <cmath>
#include <limits>

namespace rt {

std::uint16_t SrgbQuantiser::by_formula(float linear, int maximum) {
  if (!(linear > 0)) return 0; // NaN, too
  if (linear >= 1) return static_cast<std::uint16_t>(maximum);
  return static_cast<std::uint16_t>(std::floor(linear_to_srgb(static_cast<double>(linear)) * maximum + 0.5));
}

SrgbQuantiser::SrgbQuantiser(int bits) : bits_(bits) {
  if (bits != 8) return;
  for (std::size_t k = 0; k < 255; ++k) {
    float v = static_cast<float>(srgb_to_linear((static_cast<double>(k) + 0.5) / 255));
    while (by_formula(v, 255) > k) v = std::nextafter(v, 0.0f);
    while (by_formula(v, 255) <= k) v = std::nextafter(v, 1.0f);
    first_of_next_[k] = v;
  }
  first_of_next_[255] = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i <= buckets; ++i)
    lowest_[i] = static_cast<std::uint8_t>(by_formula(static_cast<float>(i) / buckets, 255));
}

} // namespace rt
