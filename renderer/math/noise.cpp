#include "renderer/math/noise.hpp"

#include "renderer/math/hashing.hpp"
#include "renderer/math/random.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace rt {
namespace {

/// The gradient at a lattice point: one of the twelve from the centre of a cube to its edges.
const Vec3& lattice_gradient(std::uint64_t seed, const Vec3& corner) {
  static constexpr std::array<Vec3, 12> gradients{{{1, 1, 0},
                                                   {-1, 1, 0},
                                                   {1, -1, 0},
                                                   {-1, -1, 0},
                                                   {1, 0, 1},
                                                   {-1, 0, 1},
                                                   {1, 0, -1},
                                                   {-1, 0, -1},
                                                   {0, 1, 1},
                                                   {0, -1, 1},
                                                   {0, 1, -1},
                                                   {0, -1, -1}}};
  constexpr std::uint64_t number_tag = 6; // the tag with which the language hashes a number
  std::uint64_t h = seed;
  for (const double k : {corner.x, corner.y, corner.z}) h = mixed_seed(h, Hasher().add(number_tag).add(k).value());
  return gradients[h % gradients.size()];
}

double fade_curve(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}
double fade_slope(double t) {
  return 30 * t * t * (t * (t - 2) + 1);
}

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

/// The lattice cell that contains a point, and the point's position in it.
struct Cell {
  Vec3 corner, offset;
};
Cell cell_of(const Vec3& p) {
  const Vec3 corner{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  return {corner, p - corner};
}

} // namespace

std::uint64_t mixed_seed(std::uint64_t seed, std::uint64_t key_hash) {
  return mix_bits((seed ^ key_hash) + golden_increment);
}

double gradient_noise(std::uint64_t seed, const Vec3& p) {
  if (!is_finite(p)) return std::numeric_limits<double>::quiet_NaN();
  const Cell place = cell_of(p);
  const Vec3 &cell = place.corner, &f = place.offset;
  const double u = fade_curve(f.x), v = fade_curve(f.y), w = fade_curve(f.z);
  const auto corner = [&](double i, double j, double k) {
    return dot(lattice_gradient(seed, {cell.x + i, cell.y + j, cell.z + k}), f - Vec3{i, j, k});
  };
  const auto edge = [&](double j, double k) { return mix(corner(0, j, k), corner(1, j, k), u); };
  const double value = mix(mix(edge(0, 0), edge(1, 0), v), mix(edge(0, 1), edge(1, 1), v), w);
  return std::clamp(value, -1.0, 1.0);
}

// The product rule along each of the three nested interpolations.
NoiseAndGradient gradient_noise_with_gradient(std::uint64_t seed, const Vec3& p) {
  const double value = gradient_noise(seed, p);
  if (!is_finite(p)) return {value, {value, value, value}};
  const auto [cell, f] = cell_of(p);
  const double u = fade_curve(f.x), v = fade_curve(f.y), w = fade_curve(f.z);
  Vec3 gradient{};
  for (int n = 0; n < 8; ++n) {
    const Vec3 at{static_cast<double>(n & 1), static_cast<double>(n >> 1 & 1), static_cast<double>(n >> 2)};
    const Vec3& g = lattice_gradient(seed, cell + at);
    const double height = dot(g, f - at);
    const double x = at.x == 0 ? 1 - u : u, y = at.y == 0 ? 1 - v : v, z = at.z == 0 ? 1 - w : w;
    const auto sign = [](double side) { return 2 * side - 1; };
    const Vec3 slopes{sign(at.x) * fade_slope(f.x) * y * z, sign(at.y) * fade_slope(f.y) * x * z,
                      sign(at.z) * fade_slope(f.z) * x * y};
    gradient += g * (x * y * z) + slopes * height;
  }
  return {value, gradient};
}

} // namespace rt
