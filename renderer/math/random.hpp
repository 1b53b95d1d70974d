#pragma once

#include <cstdint>

namespace rt {

/// The finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood, Fast Splittable Pseudorandom Number Generators, 2014):
/// every bit of the argument affects every bit of the result, and it is a bijection.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// What SplitMix64 adds to its state for each number: 2^64 divided by the golden ratio, made odd.
inline constexpr std::uint64_t golden_increment = 0x9e3779b97f4a7c15u;

/// In [0, 1), from the upper 53 bits.
constexpr double unit_interval(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

/// SplitMix64: pseudorandom numbers that are the same on every machine.
class SplitMix64 {
public:
  explicit constexpr SplitMix64(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t bits() { return mix_bits(state_ += golden_increment); }
  /// In [0, 1).
  constexpr double unit() { return unit_interval(bits()); }
  constexpr double between(double low, double high) { return low + (high - low) * unit(); }

private:
  std::uint64_t state_;
};

} // namespace rt
