#pragma once

#include "renderer/patterns/chance/fractal.hpp"

namespace rt::scene {

/// Rings about the y axis that are not quite round.
struct Wood : Fractal {
  static constexpr std::string_view noun = "wood";
  static constexpr std::string_view help = "the rings of a tree about the y axis, one unit wide, not quite round";
  double wander = 0.4, grain = 0.2;
};

std::span<const Field> fields(const Wood*);

} // namespace rt::scene

namespace rt {

/// With r the distance from the y axis, once x and z are moved by `wander` times a fractal noise at (x/2, y/8, z/2)
/// each: the ring r − ⌊r⌋, of which 0 to 0.8 rises to 1 and the rest falls to 0. `grain` of it is (1 + n)/2 with a
/// fractal noise n at (12x, y/2, 12z).
double value_at(const scene::Wood& wood, const Vec3& p);

} // namespace rt
