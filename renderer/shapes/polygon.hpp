#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/shapes/flat/parallelogram.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The interior of a closed planar chain of at least three points, which need not be convex.
struct Polygon {
  static constexpr std::string_view noun = "polygon";
  static constexpr std::string_view help = "a flat face with any number of corners";
  std::vector<Vec3> points{{-0.5, 0, 0}, {0.5, 0, 0}, {0.5, 1, 0}, {-0.5, 1, 0}};
};

std::span<const Field> fields(const Polygon*);
std::optional<Problem> check(const Polygon&);

} // namespace rt::scene

namespace rt {

struct PolygonGeometry {
  std::vector<Vec3> points;
  Vec3 normal;       ///< unit; right-handed about the points in the order written
  double extent = 0; ///< diagonal of the points' bounding box
};

PolygonGeometry geometry(const scene::Polygon& polygon);
std::optional<PolygonGeometry> placed(const PolygonGeometry& polygon, const Affine& map);
Box3 bounds(const PolygonGeometry& polygon, const Affine& map = {});

SurfacePoint surface_point(const PolygonGeometry& polygon, const Ray& ray, const Hit& hit);
constexpr std::false_type is_solid(const PolygonGeometry&) {
  return {};
}
inline Parallelogram lamp_surface(const PolygonGeometry& polygon) {
  return parallelogram_around(polygon.points, polygon.normal);
}
bool intersect(const PolygonGeometry& polygon, const Ray& ray, const Interval& range, Hit& hit);

} // namespace rt
