#include "renderer/shapes/quad.hpp"

#include "renderer/shapes/flat/flat.hpp"
#include "renderer/shapes/flat/outline.hpp"

namespace rt::scene {

std::span<const Field> fields(const Quad*) {
  static constexpr Constraint four{.min_count = 4, .max_count = 4};
  static constexpr Field table[] = {
      field<&Quad::size>("size", {"1", "edge length of a square centred at `at`", positive, 1}),
      field<&Quad::normal>("normal", {"[0, 1, 0]", "direction perpendicular to the square", nonzero, 1}),
      field<&Quad::corner>("corner", {"", "corner from which `edge_u` and `edge_v` start", any_value, 2}),
      field<&Quad::edge_u>("edge_u", {"", "one edge, as a vector", nonzero, 2}),
      field<&Quad::edge_v>("edge_v", {"", "the other edge, as a vector", nonzero, 2}),
      field<&Quad::points>("points", {"", "the four corners in order, coplanar", four, 3}),
  };
  return table;
}

std::optional<Problem> check(const Quad& quad) {
  if (quad.points) return check_outline(*quad.points);
  if (!quad.corner && !quad.edge_u && !quad.edge_v) return std::nullopt;
  if (!quad.corner)
    return Problem{quad.edge_u ? "edge_u" : "edge_v", "a quad with edges needs `corner`, where they start"};
  if (!quad.edge_u) return Problem{"corner", "a quad with `corner` needs `edge_u` and `edge_v`: `edge_u` is missing"};
  if (!quad.edge_v) return Problem{"corner", "a quad with `corner` needs `edge_u` and `edge_v`: `edge_v` is missing"};
  const Vec3 corners[] = {{}, *quad.edge_u, *quad.edge_v};
  if (is_line(corners)) return Problem{"edge_v", "`edge_u` and `edge_v` are parallel: there is no area between them"};
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {
namespace {

QuadGeometry from_points(const std::array<Vec3, 4>& points) {
  return {points, normalize(newell_normal(points)), outline_extent(points)};
}

/// The directions of a square's edges, u × v = normal.
std::pair<Vec3, Vec3> square_axes(const Vec3& normal) {
  const Vec3 level = cross({0, 1, 0}, normal);
  const Vec3 u = length(level) > 1e-9 ? normalize(level) : Vec3{1, 0, 0};
  return {u, cross(normal, u)};
}

} // namespace

QuadGeometry geometry(const scene::Quad& quad) {
  if (quad.points) {
    const auto& p = *quad.points;
    return from_points({p[0], p[1], p[2], p[3]});
  }
  if (quad.corner) {
    const Vec3 &c = *quad.corner, &u = *quad.edge_u, &v = *quad.edge_v;
    const std::array<Vec3, 4> corners{c, c + u, c + u + v, c + v};
    return {corners, normalize(cross(u, v)), outline_extent(corners)};
  }
  const Vec3 normal = normalize(quad.normal.value_or(Vec3{0, 1, 0}));
  const auto [u, v] = square_axes(normal);
  const double half = quad.size.value_or(1) / 2;
  const std::array<Vec3, 4> corners{(u + v) * -half, (u - v) * half, (u + v) * half, (v - u) * half};
  return {corners, normal, outline_extent(corners)};
}

std::optional<QuadGeometry> placed(const QuadGeometry& quad, const Affine& map) {
  const auto& p = quad.points;
  const std::array<Vec3, 4> corners{map.point(p[0]), map.point(p[1]), map.point(p[2]), map.point(p[3])};
  return QuadGeometry{corners, normalize(map.normal(quad.normal)), outline_extent(corners)};
}

Box3 bounds(const QuadGeometry& quad, const Affine& map) {
  return outline_bounds(quad.points, map);
}

SurfacePoint surface_point(const QuadGeometry& quad, const Ray& ray, const Hit& hit) {
  return flat_point(quad.points[0], quad.normal, quad.extent, ray, hit);
}

bool intersect(const QuadGeometry& quad, const Ray& ray, const Interval& range, Hit& hit) {
  return intersect_face(quad.points, quad.normal, ray, range, hit);
}

} // namespace rt
