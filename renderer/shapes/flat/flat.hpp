#pragma once

#include "renderer/math/rounding.hpp"
#include "renderer/shapes/hit.hpp"

#include <span>

/// What triangles, quads and polygons share: whether a ray passes through the outline of a planar face.
///
/// The corners are projected along the ray, so that it becomes the origin of a plane (as in Woop, Benthin and Wald,
/// Watertight Ray/Triangle Intersection, JCGT 2013, but without division). A corner's projection depends only on the
/// corner and the ray, and the sign of an edge's determinant is never wrong, at worst rounded to 0; 0 counts as on the
/// edge, and the edge belongs to the face. Hence no ray slips between two faces that share an edge with the same end
/// points, whatever their kinds; a ray that hits the edge exactly hits both.
namespace rt {

struct Projected {
  double x, y;
};

/// Along a direction whose largest component is Axis; `corner` is relative to the ray's origin. Scaled by that
/// component.
template <std::size_t Axis>
constexpr Projected projected(const Vec3& corner, const Vec3& direction) {
  constexpr std::size_t u = (Axis + 1) % 3, v = (Axis + 2) % 3;
  return {corner[u] * direction[Axis] - corner[Axis] * direction[u],
          corner[v] * direction[Axis] - corner[Axis] * direction[v]};
}

/// Positive if the origin is to the left of the line from p to q. Swapping p and q only changes the sign.
constexpr double side_of_origin(const Projected& p, const Projected& q) {
  return p.x * q.y - q.x * p.y;
}

/// Calls f.operator()<Axis>() with the axis of the direction's largest component.
template <class F>
decltype(auto) along_largest(const Vec3& direction, F&& f) {
  const Vec3 size = abs(direction);
  if (size.x >= size.y && size.x >= size.z) return f.template operator()<0>();
  if (size.y >= size.z) return f.template operator()<1>();
  return f.template operator()<2>();
}

/// The crossing of a ray with the face that `outline` encloses, in a plane perpendicular to `normal`; inside is where a
/// line outwards crosses the outline an odd number of times, edges included.
bool intersect_face(std::span<const Vec3> outline, const Vec3& normal, const Ray& ray, const Interval& range, Hit& hit);

/// A point of the plane through `anchor`; `extent` is the face's size.
inline SurfacePoint flat_point(const Vec3& anchor, const Vec3& normal, double extent, const Ray& ray, const Hit& hit) {
  const Vec3 from_anchor = reject(relative_point(ray, hit, anchor), normal);
  return {anchor + from_anchor, normal, rounding_bound(32) * (magnitude(anchor) + extent)};
}

} // namespace rt
