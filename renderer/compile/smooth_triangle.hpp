#pragma once

#include "renderer/shapes/triangle.hpp"

namespace rt {

/// A triangle that is shaded as if it were curved. The normals need not be unit vectors: they are normalised where the
/// scene's space is reached.
struct SmoothTriangleGeometry : TriangleGeometry {
  std::array<Vec3, 3> normals;
};

inline std::optional<SmoothTriangleGeometry> placed(const SmoothTriangleGeometry& triangle, const Affine& map) {
  const auto flat = placed(static_cast<const TriangleGeometry&>(triangle), map);
  if (!flat) return std::nullopt;
  const auto& [a, b, c] = triangle.normals;
  return SmoothTriangleGeometry{*flat, {normalize(map.normal(a)), normalize(map.normal(b)), normalize(map.normal(c))}};
}

/// A normal to shade with that is interpolated between the corners of a triangle.
struct InterpolatedNormal {
  Vec3 weights; ///< of the corners; their sum is 1
  std::array<Vec3, 3> normals;

  /// Carries the normals by `map` to another space.
  void carry(const Affine& map) {
    for (Vec3& normal : normals) normal = map.normal(normal);
  }
  /// The unit normal. Those of the corners are normalised before they are interpolated, as POV-Ray does; where they
  /// cancel out it is `geometric_normal`.
  Vec3 value(const Vec3& geometric_normal) const {
    const Vec3 n =
        normalize(normals[0]) * weights.x + normalize(normals[1]) * weights.y + normalize(normals[2]) * weights.z;
    const double size = length(n);
    return size > 0 ? n / size : geometric_normal;
  }
};

/// At a point of the triangle, in its space.
inline InterpolatedNormal interpolated_normal(const SmoothTriangleGeometry& triangle, const Vec3& point) {
  return {barycentric(triangle, point), triangle.normals};
}

} // namespace rt
