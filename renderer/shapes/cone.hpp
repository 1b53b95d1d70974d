#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/quadratic.hpp"
#include "renderer/shapes/revolution.hpp"

namespace rt::scene {

/// The surface swept by a circle whose radius varies linearly from `radius` at `from` to `top_radius` at `to` (0: a
/// point), closed by a disc at each end whose radius is not 0; `open` omits the discs.
struct Cone {
  static constexpr std::string_view noun = "cone";
  static constexpr std::string_view help = "a cone, or a frustum between two radii";
  Vec3 from{0, 0, 0};
  Vec3 to{0, 1, 0};
  double radius = 1;
  double top_radius = 0;
  bool open = false;
};

std::span<const Field> fields(const Cone*);
std::optional<Problem> check(const Cone&);

} // namespace rt::scene

namespace rt {

/// At height z above `base`, 0 ≤ z ≤ height, the radius is radius + slope·z.
struct ConeGeometry {
  Vec3 base;
  Vec3 axis; ///< unit
  double height = 1;
  double radius = 1;
  double top_radius = 0;
  double slope = -1; ///< (top_radius − radius) / height
  bool is_open = false;
};

ConeGeometry geometry(const scene::Cone& cone);
std::optional<ConeGeometry> placed(const ConeGeometry& cone, const Affine& map);
Box3 bounds(const ConeGeometry& cone, const Affine& map = {});

SurfacePoint surface_point(const ConeGeometry& cone, const Ray& ray, const Hit& hit);
Crossings crossings(const ConeGeometry& cone, const Ray& ray);
bool contains(const ConeGeometry& cone, const Vec3& point);
constexpr bool is_solid(const ConeGeometry& cone) {
  return !cone.is_open;
}

inline const ConeGeometry& lamp_surface(const ConeGeometry& cone) {
  return cone;
}
double area(const ConeGeometry& cone);
AreaPoint point_by_area(const ConeGeometry& cone, double u, double v);

/// The segment of a line within the cone's side, extended without end, on the nappe that the ends cut from the double
/// cone; between the planes of the ends nothing of the other nappe counts.
///
/// With the arms m and n of the ray's origin and direction (their parts perpendicular to the axis, rotated by 90°) and
/// the radius ρ + t·ρ' at the ray's height, (m + t·n)² − (ρ + t·ρ')² = a·t² + 2·b·t + c. Its discriminant b² − a·c is
/// |ρ·n − ρ'·m|² − |m × n|², which does not cancel if the ray starts far from the surface; b² − a·c is more accurate
/// close to it.
AxisRange side_span(const ConeGeometry& cone, const AxialRay& ray);

inline AxialRay axial_ray(const ConeGeometry& cone, const Ray& ray) {
  return {ray, cone.base, cone.axis, cone.height / 2, cone.height + std::max(cone.radius, cone.top_radius)};
}

inline AxisRange inner_span(const ConeGeometry& cone, const AxialRay& ray) {
  const AxisRange side = side_span(cone, ray);
  return side.is_empty() ? side : overlap(side, ray.between(cone.height));
}

inline bool intersect(const ConeGeometry& cone, const Ray& ray, const Interval& range, Hit& hit) {
  const AxialRay axial = axial_ray(cone, ray);
  return take_first(axial, inner_span(cone, axial), cone.is_open, range, hit);
}

} // namespace rt
