#include "renderer/shapes/polygon.hpp"

#include "renderer/shapes/flat/flat.hpp"
#include "renderer/shapes/flat/outline.hpp"

namespace rt::scene {

std::span<const Field> fields(const Polygon*) {
  static constexpr Constraint three_or_more{.min_count = 3};
  static constexpr Field table[] = {
      field<&Polygon::points>("points", {"[[-0.5, 0, 0], [0.5, 0, 0], [0.5, 1, 0], [-0.5, 1, 0]]",
                                         "the corners in order, coplanar; closed automatically", three_or_more}),
  };
  return table;
}

std::optional<Problem> check(const Polygon& polygon) {
  return check_outline(polygon.points);
}

} // namespace rt::scene

namespace rt {

PolygonGeometry geometry(const scene::Polygon& polygon) {
  return {polygon.points, normalize(newell_normal(polygon.points)), outline_extent(polygon.points)};
}

std::optional<PolygonGeometry> placed(const PolygonGeometry& polygon, const Affine& map) {
  PolygonGeometry image;
  image.points.reserve(polygon.points.size());
  for (const Vec3& p : polygon.points) image.points.push_back(map.point(p));
  image.normal = normalize(map.normal(polygon.normal));
  image.extent = outline_extent(image.points);
  return image;
}

Box3 bounds(const PolygonGeometry& polygon, const Affine& map) {
  return outline_bounds(polygon.points, map);
}

SurfacePoint surface_point(const PolygonGeometry& polygon, const Ray& ray, const Hit& hit) {
  return flat_point(polygon.points[0], polygon.normal, polygon.extent, ray, hit);
}

bool intersect(const PolygonGeometry& polygon, const Ray& ray, const Interval& range, Hit& hit) {
  return intersect_face(polygon.points, polygon.normal, ray, range, hit);
}

} // namespace rt
