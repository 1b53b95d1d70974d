#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/shapes/flat/parallelogram.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// A flat four-sided face: a square of `size` about the origin of object space, perpendicular to `normal`; or the
/// parallelogram at `corner` spanned by `edge_u` and `edge_v`; or four coplanar `points`, in order.
///
/// The square stands upright: two of its edges are level, along u = y × normal (along x where the normal is vertical,
/// to 1e-9), the others along normal × u.
struct Quad {
  static constexpr std::string_view noun = "quad";
  static constexpr std::string_view help = "a flat face with four corners";
  std::optional<double> size; ///< 1 if no form is specified
  std::optional<Vec3> normal; ///< +y if not specified
  std::optional<Vec3> corner, edge_u, edge_v;
  std::optional<std::vector<Vec3>> points;
};

std::span<const Field> fields(const Quad*);
std::optional<Problem> check(const Quad&);

} // namespace rt::scene

namespace rt {

struct QuadGeometry {
  std::array<Vec3, 4> points;
  Vec3 normal;       ///< unit; right-handed about the points in the order written
  double extent = 0; ///< diagonal of the points' bounding box
};

QuadGeometry geometry(const scene::Quad& quad);
std::optional<QuadGeometry> placed(const QuadGeometry& quad, const Affine& map);
Box3 bounds(const QuadGeometry& quad, const Affine& map = {});

SurfacePoint surface_point(const QuadGeometry& quad, const Ray& ray, const Hit& hit);
constexpr std::false_type is_solid(const QuadGeometry&) {
  return {};
}
inline Parallelogram lamp_surface(const QuadGeometry& quad) {
  return parallelogram_around(quad.points, quad.normal);
}
bool intersect(const QuadGeometry& quad, const Ray& ray, const Interval& range, Hit& hit);

} // namespace rt
