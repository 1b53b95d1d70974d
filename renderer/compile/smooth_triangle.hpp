#pragma once

#include "renderer/shapes/triangle.hpp"

namespace rt {

/// A triangle that is shaded as if it were curved. The normals need not be unit vectors: they are normalised where the
/// scene's space is reached.
struct SmoothTriangleGeometry {
  TriangleGeometry flat;
  std::array<Vec3, 3> normals;
};

inline std::optional<SmoothTriangleGeometry> placed(const SmoothTriangleGeometry& triangle, const Affine& map) {
  const auto flat = placed(triangle.flat, map);
  if (!flat) return std::nullopt;
  const auto& [a, b, c] = triangle.normals;
  return SmoothTriangleGeometry{*flat, {normalize(map.normal(a)), normalize(map.normal(b)), normalize(map.normal(c))}};
}

inline Box3 bounds(const SmoothTriangleGeometry& triangle, const Affine& map = {}) {
  return bounds(triangle.flat, map);
}

inline bool intersect(const SmoothTriangleGeometry& triangle, const Ray& ray, const Interval& range, Hit& hit) {
  return intersect(triangle.flat, ray, range, hit);
}

inline SurfacePoint surface_point(const SmoothTriangleGeometry& triangle, const Ray& ray, const Hit& hit) {
  return surface_point(triangle.flat, ray, hit);
}

} // namespace rt
