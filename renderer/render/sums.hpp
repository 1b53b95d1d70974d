#pragma once

#include "renderer/math/color.hpp"

#include <array>
#include <cstdint>

namespace rt {

/// A sum of numbers that does not depend on their order: each is rounded to a multiple of 2⁻⁶⁴ and added as a 128-bit
/// integer. It saturates at ±2⁶².
class FixedSum {
public:
  void add(double number);
  void add(const FixedSum& other);
  double value() const;
  friend bool operator==(const FixedSum&, const FixedSum&) = default;

  /// The integer's upper and lower half: value · 2⁶⁴.
  std::int64_t upper() const { return upper_; }
  std::uint64_t lower() const { return lower_; }
  static constexpr FixedSum from(std::int64_t upper, std::uint64_t lower) {
    FixedSum sum;
    sum.upper_ = upper;
    sum.lower_ = lower;
    return sum;
  }

private:
  std::int64_t upper_ = 0;
  std::uint64_t lower_ = 0;
};

/// The samples accumulated in a pixel. They are assigned alternately to two independent halves, so that their
/// difference estimates the error of the mean.
class PixelSums {
public:
  void add(std::uint32_t sample, const Color& radiance);
  void add(const PixelSums& other);

  std::uint32_t samples() const { return counts_[0] + counts_[1]; }
  /// Of a half, 0 or 1: its number of samples, and their sum in a channel.
  std::uint32_t& samples(std::size_t half) { return counts_[half]; }
  std::uint32_t samples(std::size_t half) const { return counts_[half]; }
  FixedSum& sum(std::size_t half, std::size_t channel) { return sums_[half][channel]; }
  const FixedSum& sum(std::size_t half, std::size_t channel) const { return sums_[half][channel]; }
  /// Black without samples.
  Color mean() const;
  /// Of one half, which must not be empty.
  Color mean(std::size_t half) const;
  /// The standard error of the mean per channel, estimated from the halves: half their difference. Infinite if one of
  /// them is empty.
  Color error() const;
  friend bool operator==(const PixelSums&, const PixelSums&) = default;

private:
  std::array<std::array<FixedSum, 3>, 2> sums_{}; // by half, then channel
  std::array<std::uint32_t, 2> counts_{};
};

} // namespace rt
