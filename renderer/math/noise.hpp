#pragma once

#include "renderer/math/vec3.hpp"

#include <cstdint>

namespace rt {

/// Gradient noise (K. Perlin, Improving Noise, SIGGRAPH 2002), with hashes instead of its permutation table, so that it
/// is not periodic: from −1 to 1, and 0 at points with integer coordinates. The same bits on every machine. NaN if the
/// point is not finite.
double gradient_noise(std::uint64_t seed, const Vec3& p);

struct NoiseAndGradient {
  double value;
  Vec3 gradient;
};
NoiseAndGradient gradient_noise_with_gradient(std::uint64_t seed, const Vec3& p);

/// A bound on its slope along an axis: the gradients' own 1, plus the fade curve's steepest, 15/8, times the largest
/// difference of two corners' values, 3.
inline constexpr double steepest_noise = 6.625;

/// How keys seed noise: each is mixed into the seed of those before it.
std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t key_hash);

} // namespace rt
