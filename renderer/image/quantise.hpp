#pragma once

#include <array>
#include <cstdint>

namespace rt {

/// Linear light to an integer from 0 to 2^bits − 1: floor((2^bits − 1)·sRGB(v) + 1/2), v clamped to 0 to 1 and NaN
/// taken as 0. For eight bits a table holds the values where the integer changes, with the same result as the formula.
class SrgbQuantiser {
public:
  /// `bits` is 8 or 16.
  explicit SrgbQuantiser(int bits);
  std::uint16_t operator()(float linear) const {
    if (bits_ != 8) return by_formula(linear, 65535);
    if (!(linear > 0)) return 0;
    if (linear >= 1) return 255;
    const std::size_t code = lowest_[static_cast<std::size_t>(linear * buckets)];
    return static_cast<std::uint16_t>(code + (linear >= first_of_next_[code]));
  }

private:
  static std::uint16_t by_formula(float linear, int maximum);

  static constexpr int buckets = 4096; // no code is so narrow that a bucket overlaps more than two
  int bits_;
  std::array<float, 256> first_of_next_{};         ///< the least value above code k's range
  std::array<std::uint8_t, buckets + 1> lowest_{}; ///< the code of a bucket's least value
};

} // namespace rt
