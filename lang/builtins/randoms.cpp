#include "lang/builtins/builtins.hpp"
#include "renderer/math/random.hpp"
#include "renderer/math/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::lang::builtins {
namespace {

constexpr std::uint64_t scrambled(std::uint64_t h) {
  return mix_bits(h + golden_increment);
}

std::optional<std::uint64_t> key_hash(BuiltinCall& c, std::size_t first) {
  std::uint64_t h = 0;
  for (std::size_t i = first; i < c.arguments.size(); ++i) {
    if (!c.has(i)) continue;
    if (c[i].is_shared() && !c[i].is(ValueKind::string) && !c[i].is(ValueKind::list)) {
      c.fail(i, "a key is a number, a string, a truth value, a colour or a list of these", "this is " + describe(c[i]));
      return std::nullopt;
    }
    h = scrambled(h ^ hash(c[i]));
  }
  return h;
}

Value random_number(BuiltinCall& c) {
  const auto h = key_hash(c, 0);
  if (!h) return Value::poison();
  return unit_interval(*h);
}

double fade_curve(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

/// The gradient at a lattice point is one of the twelve from the middle of a cube to its edges; here its product with
/// the offset from that point.
double gradient(std::uint64_t seed, double x, double y, double z, const Vec3& offset) {
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
  std::uint64_t h = seed;
  for (const double k : {x, y, z}) h = scrambled(h ^ hash(Value(k)));
  return dot(gradients[h % gradients.size()], offset);
}

double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

/// Gradient noise (K. Perlin, Improving Noise, SIGGRAPH 2002), with hashes in the place of its permutation table, so
/// that it has no period.
Value noise(BuiltinCall& c) {
  const auto seed = key_hash(c, 1);
  if (!seed) return Value::poison();
  const Vec3& p = c.vector(0);
  if (!is_finite(p)) return c.fail(0, "noise needs a finite point");
  const Vec3 cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const Vec3 f = p - cell;
  const double u = fade_curve(f.x), v = fade_curve(f.y), w = fade_curve(f.z);
  const auto corner = [&](double i, double j, double k) {
    return gradient(*seed, cell.x + i, cell.y + j, cell.z + k, f - Vec3{i, j, k});
  };
  const auto edge = [&](double j, double k) { return mix(corner(0, j, k), corner(1, j, k), u); };
  const double value = mix(mix(edge(0, 0), edge(1, 0), v), mix(edge(0, 1), edge(1, 1), v), w);
  return std::clamp(value, -1.0, 1.0);
}

} // namespace

std::span<const Builtin> randoms() {
  static constexpr Builtin table[] = {
      {"random", "key…: any", "a number from 0 up to, but not including, 1 that belongs to the key", random_number},
      {"noise_at", "p: point, seed…: any = ?",
       "smooth gradient noise, from -1 to 1 and 0 at points with whole coordinates", noise},
  };
  return table;
}

} // namespace rt::lang::builtins
