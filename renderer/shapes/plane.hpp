#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The points p with n̂·p = offset, n̂ the unit vector along `normal`; or those of one coordinate: `x: k`, `y: k` or
/// `z: k`. As a solid it is the half-space on the side the normal points away from.
struct Plane {
  static constexpr std::string_view noun = "plane";
  static constexpr std::string_view help = "an infinite flat surface; as a solid, the half-space behind it";
  std::optional<Vec3> normal; ///< +y if no form is specified
  std::optional<double> offset;
  std::optional<double> x, y, z;
};

std::span<const Field> fields(const Plane*);
std::optional<Problem> check(const Plane&);

} // namespace rt::scene

namespace rt {

/// The points p with normal·p = offset; solid where normal·p < offset. The normal is a unit vector.
struct PlaneGeometry {
  Vec3 normal;
  double offset = 0;
};

PlaneGeometry geometry(const scene::Plane& plane);
std::optional<PlaneGeometry> placed(const PlaneGeometry& plane, const Affine& map);
/// Of the solid half-space.
Box3 bounds(const PlaneGeometry& plane, const Affine& map = {});

SurfacePoint surface_point(const PlaneGeometry& plane, const Ray& ray, const Hit& hit);
Crossings crossings(const PlaneGeometry& plane, const Ray& ray);
bool contains(const PlaneGeometry& plane, const Vec3& point);
constexpr bool is_solid(const PlaneGeometry&) {
  return true;
}

[[gnu::always_inline]] inline bool intersect(const PlaneGeometry& plane, const Ray& ray, const Interval& range,
                                             Hit& hit) {
  const double approach = dot(plane.normal, ray.direction);
  const double height = plane.offset - dot(plane.normal, ray.origin);
  if (approach == 0 || (height < 0) != (approach < 0)) return false; // parallel, even if within the plane; or behind
  const double t = height / approach;
  if (!range.contains(t)) return false;
  hit = {t, 0};
  return true;
}

} // namespace rt
