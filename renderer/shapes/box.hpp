#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// A solid with axis-aligned faces: `size` about the origin of object space, or between the opposite corners `from` and
/// `to`.
struct Box {
  static constexpr std::string_view noun = "box";
  static constexpr std::string_view help = "an axis-aligned box";
  std::optional<Vec3> size; ///< 1 along each axis if neither form is specified
  std::optional<Vec3> from, to;
};

std::span<const Field> fields(const Box*);
std::optional<Problem> check(const Box&);

} // namespace rt::scene

namespace rt {

struct BoxGeometry {
  Vec3 lower, upper;
};

BoxGeometry geometry(const scene::Box& box);
std::optional<BoxGeometry> placed(const BoxGeometry& box, const Affine& map);
Box3 bounds(const BoxGeometry& box, const Affine& map = {});

SurfacePoint surface_point(const BoxGeometry& box, const Ray& ray, const Hit& hit);
Crossings crossings(const BoxGeometry& box, const Ray& ray);
bool contains(const BoxGeometry& box, const Vec3& point);
constexpr bool is_solid(const BoxGeometry&) {
  return true;
}

inline const BoxGeometry& lamp_surface(const BoxGeometry& box) {
  return box;
}
double area(const BoxGeometry& box);
AreaPoint point_by_area(const BoxGeometry& box, double u, double v);

/// Where a line enters and leaves a box, by Kay and Kajiya's slabs (Ray Tracing Complex Scenes, 1986). Part 2·axis is
/// the lower face of an axis, 2·axis + 1 the upper one. A line within a face or along an edge counts as inside.
struct BoxSpan {
  Hit enter{-std::numeric_limits<double>::infinity(), 0};
  Hit leave{std::numeric_limits<double>::infinity(), 0};

  BoxSpan(const BoxGeometry& box, const Ray& ray) {
    clip(box.lower.x - ray.origin.x, box.upper.x - ray.origin.x, ray.direction.x, 0);
    clip(box.lower.y - ray.origin.y, box.upper.y - ray.origin.y, ray.direction.y, 2);
    clip(box.lower.z - ray.origin.z, box.upper.z - ray.origin.z, ray.direction.z, 4);
  }

private:
  // A product 0·∞, for a line within a face's plane, is NaN and fails every comparison: it clips nothing.
  void clip(double lower, double upper, double direction, std::uint32_t part) {
    const double inverse = 1 / direction;
    const std::uint32_t backward = std::signbit(direction) ? 1 : 0;
    const double first = (backward != 0 ? upper : lower) * inverse;
    const double last = (backward != 0 ? lower : upper) * inverse;
    enter.part = first > enter.t ? part + backward : enter.part;
    enter.t = first > enter.t ? first : enter.t;
    leave.part = last < leave.t ? part + 1 - backward : leave.part;
    leave.t = last < leave.t ? last : leave.t;
  }
};

inline bool intersect(const BoxGeometry& box, const Ray& ray, const Interval& range, Hit& hit) {
  const BoxSpan span(box, ray);
  return span.enter.t <= span.leave.t && take_first(span.enter, span.leave, range, hit);
}

} // namespace rt
