#pragma once

#include "renderer/math/random.hpp"
#include "renderer/math/vec3.hpp"

#include <cstdint>
#include <string>

namespace rt::tools::oracle {

/// Random numbers for scenes. So that they are the same with every compiler, no two are drawn in the arguments of one
/// call or on both sides of an operator: there g++ drew the last first, and what is now drawn backwards preserves the
/// scenes of the long runs.
class Dice : public SplitMix64 {
public:
  using SplitMix64::SplitMix64;

  /// From 0 to count − 1.
  int below(int count) { return static_cast<int>(unit() * count); }
  bool chance(double probability) { return unit() < probability; }
  double sign() { return chance(0.5) ? 1 : -1; }
  /// For a scaling: one in ten mirrors.
  double factor(double low, double high) {
    const double size = between(low, high);
    return chance(0.1) ? -size : size;
  }
  Vec3 vector(double low, double high) {
    const double x = between(low, high), y = between(low, high);
    return {x, y, between(low, high)};
  }
  /// The same in the scene's unit of length.
  double length(double low, double high) { return length_unit * between(low, high); }
  Vec3 point(double low, double high) { return vector(low, high) * length_unit; }
  /// Uniform over the unit sphere.
  Vec3 direction() {
    Vec3 v;
    do v = vector(-1, 1);
    while (dot(v, v) > 1 || dot(v, v) < 0.01);
    return normalize(v);
  }
  /// The same, with a random length.
  Vec3 arrow(double shortest, double longest) {
    const double size = between(shortest, longest);
    return direction() * size;
  }

  double length_unit = 1; ///< in scene units
};

/// The seed of the `index`-th scene of a run, independent of its neighbours'.
inline std::uint64_t scene_seed(std::uint64_t run_seed, std::uint64_t index) {
  return Dice(Dice(run_seed).bits() ^ (index * 0xd1342543de82ef95)).bits();
}

} // namespace rt::tools::oracle
