#pragma once

#include "renderer/sampling/mappings.hpp"
#include "renderer/shapes/hit.hpp"

#include <algorithm>
#include <limits>
#include <optional>

/// What cylinders and cones share: they are surfaces of revolution, cut off by two planes perpendicular to the axis.
namespace rt {

inline constexpr std::uint32_t side_part = 0, base_part = 1, top_part = 2;

/// The segment of a line between two parameters, and the surfaces where it begins and ends.
struct AxisRange {
  Hit enter{-std::numeric_limits<double>::infinity(), side_part};
  Hit leave{std::numeric_limits<double>::infinity(), side_part};

  static AxisRange empty() { return {{1, side_part}, {0, side_part}}; }
  bool is_empty() const { return !(enter.t <= leave.t); }
};

/// A ray relative to the base of an axis, with its origin moved close to it: rounding errors then stay in proportion to
/// the shape. `advance` is the t that was skipped.
struct AxialRay {
  Vec3 origin; ///< relative to the base
  Vec3 direction;
  Vec3 axis;
  double advance = 0;

  /// `size` is roughly how large the shape is, `middle` how high above the base its middle is.
  AxialRay(const Ray& ray, const Vec3& base, const Vec3& unit_axis, double middle, double size)
      : origin(ray.origin - base), direction(ray.direction), axis(unit_axis) {
    if (dot(origin, origin) > 64 * size * size) {
      advance = dot(axis * middle - origin, direction) / dot(direction, direction);
      origin = origin + direction * advance;
    }
  }

  /// The parts perpendicular to the axis, rotated by 90°: as long as the distance from the axis.
  Vec3 origin_arm() const { return cross(origin, axis); }
  Vec3 direction_arm() const { return cross(direction, axis); }

  /// The segment between the planes at the heights 0 and `top`. A line within a plane counts as between: the product
  /// 0·∞ is NaN, and no bound.
  AxisRange between(double top) const {
    const double height = dot(origin, axis), inverse = 1 / dot(direction, axis);
    const bool falls = std::signbit(inverse);
    const double first = (falls ? top - height : -height) * inverse;
    const double last = (falls ? -height : top - height) * inverse;
    return {{first, falls ? top_part : base_part}, {last, falls ? base_part : top_part}};
  }

  /// In terms of the caller's ray.
  Hit restored(const Hit& hit) const { return {hit.t + advance, hit.part}; }
};

/// The part of `side` that is also in `slab`; where both begin or end together, the side wins.
inline AxisRange overlap(const AxisRange& side, const AxisRange& slab) {
  AxisRange both;
  both.enter.part = slab.enter.t > side.enter.t ? slab.enter.part : side.enter.part;
  both.enter.t = slab.enter.t > side.enter.t ? slab.enter.t : side.enter.t;
  both.leave.part = slab.leave.t < side.leave.t ? slab.leave.part : side.leave.part;
  both.leave.t = slab.leave.t < side.leave.t ? slab.leave.t : side.leave.t;
  return both;
}

/// The nearest crossing with a solid's surface, or with its side alone if it is open: passing through an open end is
/// not a hit.
inline bool take_first(const AxialRay& ray, const AxisRange& inside, bool is_open, const Interval& range, Hit& hit) {
  if (inside.is_empty()) return false;
  const Hit enter = ray.restored(inside.enter), leave = ray.restored(inside.leave);
  if (!is_open) return take_first(enter, leave, range, hit);
  if (enter.part == side_part && range.contains(enter.t)) return hit = enter, true;
  if (leave.part == side_part && range.contains(leave.t)) return hit = leave, true;
  return false;
}

inline Crossings crossings_of(const AxialRay& ray, const AxisRange& inside) {
  Crossings found;
  if (inside.enter.t < inside.leave.t) found.add(ray.restored(inside.enter), ray.restored(inside.leave));
  return found;
}

/// The area of the discs that close it; none if it is open.
double ends_area(double base_radius, double top_radius, bool is_open);

/// Samples the whole surface of a cylinder or cone with these radii at base and top: `u` is divided among base, top and
/// side in proportion to their areas. Nothing if the side is chosen; then `u` is rescaled to 0 to 1 within the side.
template <class G>
std::optional<AreaPoint> point_of_ends(const G& shape, const std::array<double, 2>& radii, bool is_open, double& u,
                                       double v) {
  const double whole = area(shape), ends = ends_area(radii[0], radii[1], is_open) / whole;
  if (u >= ends) {
    u = std::min((u - ends) / (1 - ends), 1.0);
    return std::nullopt;
  }
  const double base = ends_area(radii[0], 0, is_open) / whole;
  const bool is_base = u < base;
  const double within = is_base ? u / base : (u - base) / (ends - base);
  const Vec2 d = to_disc(std::min(within, 1.0), v);
  const Vec3 across = TangentFrame(shape.axis).vector({d.x, d.y, 0});
  if (is_base) return AreaPoint{shape.base + across * radii[0], -shape.axis};
  return AreaPoint{shape.base + shape.axis * shape.height + across * radii[1], shape.axis};
}

/// The unit vector from the axis to a point, perpendicular to the axis to full precision; zero if the point is on
/// it.
Vec3 radial_direction(const Vec3& from_base, const Vec3& axis);

} // namespace rt
