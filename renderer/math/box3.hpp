#pragma once

#include "renderer/math/vec3.hpp"

#include <limits>

namespace rt {

/// An axis-aligned box; empty (lower > upper) until something is put in. Infinite sides are allowed.
struct Box3 {
  Vec3 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Vec3 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
             -std::numeric_limits<double>::infinity()};

  constexpr bool is_empty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
  bool is_finite() const { return rt::is_finite(lower) && rt::is_finite(upper); }
  constexpr void extend(const Vec3& p) { lower = min(lower, p), upper = max(upper, p); }
  constexpr void extend(const Box3& b) { lower = min(lower, b.lower), upper = max(upper, b.upper); }
  constexpr Vec3 center() const { return (lower + upper) * 0.5; }
  constexpr Vec3 extent() const { return upper - lower; }
  constexpr bool contains(const Vec3& p) const {
    return p.x >= lower.x && p.x <= upper.x && p.y >= lower.y && p.y <= upper.y && p.z >= lower.z && p.z <= upper.z;
  }
  friend constexpr bool operator==(const Box3&, const Box3&) = default;
};

/// The intersection, the empty box if there is none.
constexpr Box3 overlap(const Box3& a, const Box3& b) {
  const Box3 both{max(a.lower, b.lower), min(a.upper, b.upper)};
  return both.is_empty() ? Box3{} : both;
}

/// The box that contains all of space.
inline Box3 all_space() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {{-inf, -inf, -inf}, {inf, inf, inf}};
}

} // namespace rt
