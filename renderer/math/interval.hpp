#pragma once

#include <limits>

namespace rt {

/// The numbers t with lower < t ≤ upper. Along a ray: from its origin (or the last hit) to the best hit found so far.
/// An infinite t is in no interval with finite bounds.
struct Interval {
  double lower = 0;
  double upper = std::numeric_limits<double>::max();

  constexpr bool contains(double t) const { return t > lower && t <= upper; }
  friend constexpr bool operator==(const Interval&, const Interval&) = default;
};

} // namespace rt
