#pragma once

#include "renderer/shapes/hit.hpp"

#include <limits>

/// What cylinders and cones share: they turn about an axis and end at two planes across it.
namespace rt {

inline constexpr std::uint32_t side_part = 0, base_part = 1, top_part = 2;

/// The stretch of a line between two parameters, and the surfaces it begins and ends at.
struct Span {
  Hit enter{-std::numeric_limits<double>::infinity(), side_part};
  Hit leave{std::numeric_limits<double>::infinity(), side_part};

  static Span empty() { return {{1, side_part}, {0, side_part}}; }
  bool is_empty() const { return !(enter.t <= leave.t); }
};

/// A ray as seen from the base of an axis, from an origin that is not far away: rounding then stays in proportion to
/// the shape. `advance` is the t that was left behind.
struct AxialRay {
  Vec3 origin; ///< relative to the base
  Vec3 direction;
  double advance = 0;
  double height;      ///< of the origin, along the axis
  double climb;       ///< of the direction
  Vec3 origin_arm;    ///< origin × axis: perpendicular to the axis, as long as the distance from it
  Vec3 direction_arm; ///< direction × axis

  /// `size` is about how large the shape is, `middle` how high above the base its middle lies.
  AxialRay(const Ray& ray, const Vec3& base, const Vec3& axis, double middle, double size)
      : origin(ray.origin - base), direction(ray.direction) {
    if (dot(origin, origin) > 64 * size * size) {
      advance = dot(axis * middle - origin, direction) / dot(direction, direction);
      origin = origin + direction * advance;
    }
    height = dot(origin, axis);
    climb = dot(direction, axis);
    origin_arm = cross(origin, axis);
    direction_arm = cross(direction, axis);
  }

  /// The stretch between the planes at the heights 0 and `top`. A line within a plane counts as between.
  Span between(double top) const {
    Span span;
    if (climb == 0) return height >= 0 && height <= top ? span : Span::empty();
    const Hit base{-height / climb, base_part}, end{(top - height) / climb, top_part};
    return climb > 0 ? Span{base, end} : Span{end, base};
  }

  /// As the caller's ray counts.
  Hit restored(const Hit& hit) const { return {hit.t + advance, hit.part}; }
};

/// The part of `side` that is also in `slab`; where both begin or end together it is at the side.
inline Span overlap(const Span& side, const Span& slab) {
  return {slab.enter.t > side.enter.t ? slab.enter : side.enter, slab.leave.t < side.leave.t ? slab.leave : side.leave};
}

/// The nearest crossing of a solid's surface, or of its side alone where it is open: what would go through an end does
/// not hit it.
inline bool take_first(const AxialRay& ray, const Span& inside, bool is_open, const Interval& range, Hit& hit) {
  if (inside.is_empty()) return false;
  const Hit enter = ray.restored(inside.enter), leave = ray.restored(inside.leave);
  if (!is_open) return take_first(enter, leave, range, hit);
  if (enter.part == side_part && range.contains(enter.t)) return hit = enter, true;
  if (leave.part == side_part && range.contains(leave.t)) return hit = leave, true;
  return false;
}

inline Crossings crossings_of(const AxialRay& ray, const Span& inside) {
  Crossings found;
  if (inside.enter.t < inside.leave.t) found.add(ray.restored(inside.enter), ray.restored(inside.leave));
  return found;
}

/// The unit vector from the axis to a point, perpendicular to the axis to full precision; zero where the point is on
/// it.
Vec3 radial_direction(const Vec3& from_base, const Vec3& axis);

} // namespace rt
