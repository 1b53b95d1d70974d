#pragma once

#include "renderer/math/random.hpp"

#include <array>
#include <cstdint>

namespace rt {

/// The first four dimensions of Sobol's sequence (direction numbers of S. Joe and F. Kuo, Constructing Sobol Sequences
/// with Better Two-Dimensional Projections, 2008), as fractions of 2³². Index and coordinates have their bits reversed,
/// as `scramble_reversed` expects.
std::array<std::uint32_t, 4> reversed_sobol(std::uint32_t reversed_index);

/// Owen's nested uniform scrambling of a number with reversed bits (N. Vegdahl, Building a Better LK Hash, 2021, after
/// S. Laine and T. Karras): whether a bit is flipped depends on the bits before it and on `seed`.
constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// The first groups of a sample's numbers: the position within the pixel, and on the lens; then those for the
/// integrators.
inline constexpr std::uint32_t camera_group = 0, lens_group = 1, first_free_group = 2;

/// All the numbers of one sample of a pixel, four at a time: a group is a point of Sobol's sequence. Each group has a
/// scrambling of its own for the samples' order, so that groups are independent, and for the coordinates (B. Burley,
/// Practical Hash-based Owen Scrambling, 2020). They depend only on seed, pixel and the sample's number.
///
/// The samples of a pixel are assigned alternately to two halves, which are independent of each other.
class SampleStream {
public:
  constexpr SampleStream() = default;
  constexpr SampleStream(std::uint64_t seed, int x, int y, std::uint32_t sample)
      : key_(mix_bits(mix_bits(mix_bits(seed + golden_increment) + static_cast<std::uint64_t>(x)) ^
                      (static_cast<std::uint64_t>(y) << 32 | (sample & 1u)))),
        reversed_index_(reverse_bits(sample >> 1)) {}

  /// Between 0 and 1, both excluded.
  std::array<double, 4> group(std::uint32_t number) const {
    const std::uint64_t a = mix_bits(key_ + (3 * number + 1) * golden_increment);
    const std::uint64_t b = mix_bits(key_ + (3 * number + 2) * golden_increment);
    const std::uint64_t c = mix_bits(key_ + (3 * number + 3) * golden_increment);
    const auto point = reversed_sobol(scramble_reversed(reversed_index_, lower(c)));
    return {unit(point[0], lower(a)), unit(point[1], upper(a)), unit(point[2], lower(b)), unit(point[3], upper(b))};
  }

private:
  static constexpr std::uint32_t lower(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
  static constexpr std::uint32_t upper(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }
  static constexpr double unit(std::uint32_t reversed, std::uint32_t seed) {
    return (reverse_bits(scramble_reversed(reversed, seed)) + 0.5) * 0x1p-32;
  }

  std::uint64_t key_ = 0;
  std::uint32_t reversed_index_ = 0;
};

} // namespace rt
