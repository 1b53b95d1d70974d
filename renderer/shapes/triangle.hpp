#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/shapes/flat/flat.hpp"

namespace rt::scene {

/// A triangle with its edges. `normals`, one per corner or none at all, are interpolated over it to make it look
/// curved: each is transformed to the scene and normalised before interpolation.
struct Triangle {
  static constexpr std::string_view noun = "triangle";
  static constexpr std::string_view help = "a flat or smooth-shaded triangle";
  std::array<Vec3, 3> points{Vec3{-0.5, 0, 0}, Vec3{0.5, 0, 0}, Vec3{0, 1, 0}};
  std::vector<Vec3> normals;
};

std::span<const Field> fields(const Triangle*);
std::optional<Problem> check(const Triangle&);

} // namespace rt::scene

namespace rt {

struct TriangleGeometry {
  std::array<Vec3, 3> points;
};

TriangleGeometry geometry(const scene::Triangle& triangle);
std::optional<TriangleGeometry> placed(const TriangleGeometry& triangle, const Affine& map);
Box3 bounds(const TriangleGeometry& triangle, const Affine& map = {});

/// The normal is right-handed about the corners' order.
inline SurfacePoint surface_point(const TriangleGeometry& triangle, const Ray& ray, const Hit& hit) {
  const Vec3 ab = triangle.points[1] - triangle.points[0], ac = triangle.points[2] - triangle.points[0];
  return flat_point(triangle.points[0], normalize(cross(ab, ac)), magnitude(ab) + magnitude(ac), ray, hit);
}
constexpr std::false_type is_solid(const TriangleGeometry&) {
  return {};
}

inline const TriangleGeometry& lamp_surface(const TriangleGeometry& triangle) {
  return triangle;
}
double area(const TriangleGeometry& triangle);
AreaPoint point_by_area(const TriangleGeometry& triangle, double u, double v);

/// The barycentric coordinates of a point of the triangle's plane; their sum is 1.
Vec3 barycentric(const TriangleGeometry& triangle, const Vec3& point);

template <std::size_t Axis>
inline bool intersect_along(const TriangleGeometry& triangle, const Ray& ray, const Interval& range, Hit& hit) {
  const Vec3 a = triangle.points[0] - ray.origin;
  const Vec3 b = triangle.points[1] - ray.origin;
  const Vec3 c = triangle.points[2] - ray.origin;
  const Projected p = projected<Axis>(a, ray.direction);
  const Projected q = projected<Axis>(b, ray.direction);
  const Projected r = projected<Axis>(c, ray.direction);
  // Twice the areas opposite the corners: the barycentric coordinates of the hit, times their sum.
  const double u = side_of_origin(q, r), v = side_of_origin(r, p), w = side_of_origin(p, q);
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return false;
  const double area = u + v + w;
  if (area == 0) return false; // seen edge-on
  const double t = (u * a[Axis] + v * b[Axis] + w * c[Axis]) / (area * ray.direction[Axis]);
  if (!range.contains(t)) return false;
  hit = {t, 0};
  return true;
}

inline bool intersect(const TriangleGeometry& triangle, const Ray& ray, const Interval& range, Hit& hit) {
  return along_largest(ray.direction,
                       [&]<std::size_t Axis>() { return intersect_along<Axis>(triangle, ray, range, hit); });
}

/// A triangle that is shaded as if it were curved. The normals need not be unit vectors: they are normalised in scene
/// space.
struct SmoothTriangleGeometry : TriangleGeometry {
  std::array<Vec3, 3> normals;
};

std::optional<SmoothTriangleGeometry> placed(const SmoothTriangleGeometry& triangle, const Affine& map);

/// A shading normal interpolated between the corners of a triangle.
struct InterpolatedNormal {
  Vec3 weights; ///< of the corners; their sum is 1
  std::array<Vec3, 3> normals;

  /// Transforms the normals by `map` to another space.
  void carry(const Affine& map) {
    for (Vec3& normal : normals) normal = map.normal(normal);
  }
  /// The unit normal. Those of the corners are normalised before they are interpolated, as in POV-Ray; if they cancel
  /// out it is `geometric_normal`.
  Vec3 value(const Vec3& geometric_normal) const;
};

/// At a point of the triangle, in its space.
InterpolatedNormal interpolated_normal(const SmoothTriangleGeometry& triangle, const Vec3& point);

} // namespace rt
