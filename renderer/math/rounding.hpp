#pragma once

#include "renderer/math/affine.hpp"
#include "renderer/math/box3.hpp"

#include <limits>

namespace rt {

/// A bound on the relative error of n successive roundings: n·u / (1 − n·u), u = 2⁻⁵³ (Higham, Accuracy and Stability
/// of Numerical Algorithms, section 3.1).
constexpr double rounding_bound(int n) {
  constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
  return n * unit / (1 - n * unit);
}

/// The sum of the coordinates' magnitudes: a scale that bounds the rounding error of a dot product with a unit vector.
inline double magnitude(const Vec3& p) {
  return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
}

/// A bound on the magnitudes of the box's points; 0 for an empty one.
inline double reach_of(const Box3& box) {
  return box.is_empty() ? 0 : magnitude(max(abs(box.lower), abs(box.upper)));
}

/// A bound on the distance between the computed `map.point(p)` and the exact image, where p itself may be off by
/// `error`.
double mapped_error(const Affine& map, const Vec3& p, double error);

} // namespace rt
