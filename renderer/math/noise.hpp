#pragma once

#include "renderer/math/vec3.hpp"

#include <cstdint>

namespace rt {

/// Gradient noise (K. Perlin, Improving Noise, SIGGRAPH 2002), with hashes in the place of its permutation table, so
/// that it has no period: from −1 to 1, and 0 at points with whole coordinates. The same bits on every machine. Not a
/// number where the point is not finite.
double gradient_noise(std::uint64_t seed, const Vec3& p);

struct NoiseAndGradient {
  double value;
  Vec3 gradient;
};
NoiseAndGradient gradient_noise_with_gradient(std::uint64_t seed, const Vec3& p);

/// It changes no faster than this along an axis: the gradients' own 1, and the fade curve's steepest, 15/8, times the
/// largest difference of two corners' heights, 3.
inline constexpr double steepest_noise = 6.625;

/// How noise is seeded by keys: each is mixed into the seed of those before it.
std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t key_hash);

} // namespace rt
