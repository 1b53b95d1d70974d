#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/quadratic.hpp"
#include "renderer/shapes/revolution.hpp"

namespace rt::scene {

/// The points at `radius` from the segment `from`–`to`, and the two discs that close it; or, about the origin of object
/// space, along `axis` for `height` (half of it each way). `open` omits the discs; `infinite` extends it along the axis
/// both ways.
struct Cylinder {
  static constexpr std::string_view noun = "cylinder";
  static constexpr std::string_view help = "a cylinder between two points, or along an axis";
  std::optional<Vec3> from, to;
  std::optional<Vec3> axis;     ///< +y if neither form is specified
  std::optional<double> height; ///< 1 if not specified
  double radius = 1;
  bool open = false;
  bool infinite = false;
};

std::span<const Field> fields(const Cylinder*);
std::optional<Problem> check(const Cylinder&);

} // namespace rt::scene

namespace rt {

struct CylinderGeometry {
  enum class Extent : std::uint8_t { closed, open, infinite };
  Vec3 base; ///< the end at height 0, on the axis
  Vec3 axis; ///< unit
  double height = 1;
  double radius = 1;
  Extent extent = Extent::closed; ///< if infinite, the height is meaningless
};

CylinderGeometry geometry(const scene::Cylinder& cylinder);
std::optional<CylinderGeometry> placed(const CylinderGeometry& cylinder, const Affine& map);
Box3 bounds(const CylinderGeometry& cylinder, const Affine& map = {});

SurfacePoint surface_point(const CylinderGeometry& cylinder, const Ray& ray, const Hit& hit);
Crossings crossings(const CylinderGeometry& cylinder, const Ray& ray);
bool contains(const CylinderGeometry& cylinder, const Vec3& point);
constexpr bool is_solid(const CylinderGeometry& cylinder) {
  return cylinder.extent != CylinderGeometry::Extent::open;
}

inline const CylinderGeometry& lamp_surface(const CylinderGeometry& cylinder) {
  return cylinder;
}
double area(const CylinderGeometry& cylinder);
AreaPoint point_by_area(const CylinderGeometry& cylinder, double u, double v);

/// The segment of a line within the cylinder's side, extended without end: a circle's chord in the plane perpendicular
/// to the axis. a·t² + 2·b·t + c is the squared distance from the axis less the squared radius. Its discriminant is
/// computed from the line's distance from the axis, (origin · (direction × axis)) / |direction × axis|, which does not
/// cancel; but for an origin close to the surface and a nearly tangent direction, b² − a·c is more accurate.
inline AxisRange side_span(const CylinderGeometry& cylinder, const AxialRay& ray) {
  const double radius_squared = cylinder.radius * cylinder.radius;
  const Vec3 n = ray.direction_arm();
  const double a = dot(n, n), aside = dot(ray.origin, n);
  double d = radius_squared * a - aside * aside;
  const Vec3 m = ray.origin_arm();
  const double c = dot(m, m) - radius_squared;
  if (c >= 0 && !(d >= 0 && a > 0)) return AxisRange::empty();
  if (a == 0) return {}; // along the axis, inside
  const double b = dot(m, n);
  if (16 * std::abs(c) < radius_squared && 16 * b * b < radius_squared * a) d = b * b - a * c;
  if (c >= 0 && d < 0) return AxisRange::empty();
  const QuadraticRoots roots(a, b, c, std::max(d, 0.0));
  return {{std::min(roots.first, roots.second), side_part}, {std::max(roots.first, roots.second), side_part}};
}

/// The segment within the solid that the cylinder is, or would be if it were closed.
inline AxisRange inner_span(const CylinderGeometry& cylinder, const AxialRay& ray) {
  const AxisRange side = side_span(cylinder, ray);
  if (cylinder.extent == CylinderGeometry::Extent::infinite || side.is_empty()) return side;
  return overlap(side, ray.between(cylinder.height));
}

inline AxialRay axial_ray(const CylinderGeometry& cylinder, const Ray& ray) {
  return {ray, cylinder.base, cylinder.axis, cylinder.height / 2, cylinder.height + cylinder.radius};
}

/// Whether the line certainly misses the side, as most do that cross the box of a slanted cylinder. It does if |o·n| >
/// r·|n|, n = d × axis. The rounding errors of both sides together are below e = 2⁻⁴⁸·(|o| + r)·|d|, and with δ = 2⁻¹⁰
/// (r·|n| + e)² ≤ (1 + δ)·r²·|n|² + (1 + 1/δ)·e².
inline bool passes_by(const CylinderGeometry& cylinder, const Ray& ray) {
  const Vec3 origin = ray.origin - cylinder.base, n = cross(ray.direction, cylinder.axis);
  const double aside = dot(origin, n), radius_squared = cylinder.radius * cylinder.radius;
  const double roundings = 0x1p-84 * (dot(origin, origin) + radius_squared) * dot(ray.direction, ray.direction);
  return aside * aside > (1 + 0x1p-10) * radius_squared * dot(n, n) + roundings;
}

inline bool intersect(const CylinderGeometry& cylinder, const Ray& ray, const Interval& range, Hit& hit) {
  if (passes_by(cylinder, ray)) return false;
  const AxialRay axial = axial_ray(cylinder, ray);
  return take_first(axial, inner_span(cylinder, axial), !is_solid(cylinder), range, hit);
}

} // namespace rt
