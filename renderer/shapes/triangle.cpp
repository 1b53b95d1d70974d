#include "renderer/shapes/triangle.hpp"

#include "renderer/sampling/mappings.hpp"
#include "renderer/shapes/flat/outline.hpp"

#include <fmt/format.h>

namespace rt::scene {

std::span<const Field> fields(const Triangle*) {
  static constexpr Constraint three{.min_count = 3, .max_count = 3};
  static constexpr Constraint none_or_three{.max_count = 3};
  static constexpr Field table[] = {
      field<&Triangle::points>("points", {"[[-0.5, 0, 0], [0.5, 0, 0], [0, 1, 0]]", "the three corners", three}),
      field<&Triangle::normals>("normals",
                                {"[]", "a normal for each corner, for smooth shading; or none", none_or_three}),
  };
  return table;
}

std::optional<Problem> check(const Triangle& triangle) {
  if (is_line(triangle.points))
    return Problem{"points", "the three points lie on one line: there is no area between them"};
  if (triangle.normals.empty()) return std::nullopt;
  if (triangle.normals.size() != 3)
    return Problem{"normals", fmt::format("a triangle has three normals, one for each corner, or none; here are {}",
                                          triangle.normals.size())};
  for (const Vec3& n : triangle.normals) {
    if (n == Vec3{}) return Problem{"normals", "a normal must have a direction: it cannot be [0, 0, 0]"};
  }
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

TriangleGeometry geometry(const scene::Triangle& triangle) {
  return {triangle.points};
}

std::optional<TriangleGeometry> placed(const TriangleGeometry& triangle, const Affine& map) {
  const auto& p = triangle.points;
  return TriangleGeometry{{map.point(p[0]), map.point(p[1]), map.point(p[2])}};
}

Box3 bounds(const TriangleGeometry& triangle, const Affine& map) {
  return outline_bounds(triangle.points, map);
}

Vec3 barycentric(const TriangleGeometry& triangle, const Vec3& point) {
  const Vec3 ab = triangle.points[1] - triangle.points[0], ac = triangle.points[2] - triangle.points[0];
  const Vec3 ap = point - triangle.points[0];
  const Vec3 normal = cross(ab, ac);
  const double whole = dot(normal, normal);
  const double b = dot(cross(ap, ac), normal) / whole, c = dot(cross(ab, ap), normal) / whole;
  return {1 - b - c, b, c};
}

std::optional<SmoothTriangleGeometry> placed(const SmoothTriangleGeometry& triangle, const Affine& map) {
  const std::optional<TriangleGeometry> flat = placed(static_cast<const TriangleGeometry&>(triangle), map);
  if (!flat) return std::nullopt;
  const auto& [a, b, c] = triangle.normals;
  return SmoothTriangleGeometry{*flat, {normalize(map.normal(a)), normalize(map.normal(b)), normalize(map.normal(c))}};
}

Vec3 InterpolatedNormal::value(const Vec3& geometric_normal) const {
  const Vec3 n =
      normalize(normals[0]) * weights.x + normalize(normals[1]) * weights.y + normalize(normals[2]) * weights.z;
  const double size = length(n);
  return size > 0 ? n / size : geometric_normal;
}

InterpolatedNormal interpolated_normal(const SmoothTriangleGeometry& triangle, const Vec3& point) {
  return {barycentric(triangle, point), triangle.normals};
}

double area(const TriangleGeometry& triangle) {
  const auto& [a, b, c] = triangle.points;
  return length(cross(b - a, c - a)) / 2;
}

AreaPoint point_by_area(const TriangleGeometry& triangle, double u, double v) {
  const auto& [a, b, c] = triangle.points;
  const Vec3 weights = to_triangle(u, v);
  return {a * weights.x + b * weights.y + c * weights.z, normalize(cross(b - a, c - a))};
}

} // namespace rt
