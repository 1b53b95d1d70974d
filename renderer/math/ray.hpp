#pragma once

#include "renderer/math/vec3.hpp"

namespace rt {

/// The half-line origin + t·direction, t > 0. The direction need not be a unit vector: t is in multiples of it.
struct Ray {
  Vec3 origin;
  Vec3 direction;

  constexpr Vec3 at(double t) const { return origin + direction * t; }
};

} // namespace rt
