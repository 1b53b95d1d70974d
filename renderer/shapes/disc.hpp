#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The points of the plane through the origin of object space, perpendicular to `normal`, at a distance between `hole`
/// and `radius` from the origin, both included.
struct Disc {
  static constexpr std::string_view noun = "disc";
  static constexpr std::string_view help = "a flat disc, with or without a hole";
  Vec3 normal{0, 1, 0};
  double radius = 1;
  double hole = 0;
};

std::span<const Field> fields(const Disc*);
std::optional<Problem> check(const Disc&);

} // namespace rt::scene

namespace rt {

struct DiscGeometry {
  Vec3 center;
  Vec3 normal; ///< unit
  double radius = 1;
  double hole = 0;
};

DiscGeometry geometry(const scene::Disc& disc);
std::optional<DiscGeometry> placed(const DiscGeometry& disc, const Affine& map);
Box3 bounds(const DiscGeometry& disc, const Affine& map = {});

SurfacePoint surface_point(const DiscGeometry& disc, const Ray& ray, const Hit& hit);
constexpr std::false_type is_solid(const DiscGeometry&) {
  return {};
}

inline const DiscGeometry& lamp_surface(const DiscGeometry& disc) {
  return disc;
}
double area(const DiscGeometry& disc);
AreaPoint point_by_area(const DiscGeometry& disc, double u, double v);

inline bool intersect(const DiscGeometry& disc, const Ray& ray, const Interval& range, Hit& hit) {
  const double approach = dot(disc.normal, ray.direction);
  if (approach == 0) return false;
  const Vec3 from_center = ray.origin - disc.center;
  const double t = -dot(disc.normal, from_center) / approach;
  if (!range.contains(t)) return false;
  const Vec3 p = from_center + ray.direction * t;
  const double distance_squared = dot(p, p);
  if (!(distance_squared <= disc.radius * disc.radius && distance_squared >= disc.hole * disc.hole)) return false;
  hit = {t, 0};
  return true;
}

/// The bounding box of the image of a disc; `normal` is a unit vector.
Box3 disc_bounds(const Affine& map, const Vec3& center, const Vec3& normal, double radius);

} // namespace rt
