#include "renderer/shapes/flat.hpp"

#include "renderer/math/rounding.hpp"

namespace rt {
namespace {

/// Whether the origin is inside a closed chain of projected points, or on it.
template <std::size_t Axis>
bool encloses_origin(std::span<const Vec3> outline, const Ray& ray) {
  bool is_inside = false;
  Projected p = projected<Axis>(outline.back() - ray.origin, ray.direction);
  for (const Vec3& corner : outline) {
    const Projected q = projected<Axis>(corner - ray.origin, ray.direction);
    if ((p.y > 0) != (q.y > 0)) {
      const double side = side_of_origin(p, q);
      if (side == 0) return true;
      if ((side > 0) == (q.y > p.y)) is_inside = !is_inside; // crosses the half-line of positive x
    } else if (p.y == 0 && q.y == 0 && (p.x > 0) != (q.x > 0)) {
      return true;
    }
    if (q.x == 0 && q.y == 0) return true;
    p = q;
  }
  return is_inside;
}

} // namespace

bool intersect_face(std::span<const Vec3> outline, const Vec3& normal, const Ray& ray, const Interval& range,
                    Hit& hit) {
  const double approach = dot(normal, ray.direction);
  if (approach == 0) return false;
  const double t = dot(normal, outline.front() - ray.origin) / approach;
  return along_largest(ray.direction, [&]<std::size_t Axis>() {
    // A ray almost within the plane may meet it, by rounding, anywhere: no farther off than the corners are.
    const auto [least, most] = std::minmax_element(outline.begin(), outline.end(),
                                                   [](const Vec3& a, const Vec3& b) { return a[Axis] < b[Axis]; });
    const double s = ((*least)[Axis] - ray.origin[Axis]) / ray.direction[Axis];
    const double e = ((*most)[Axis] - ray.origin[Axis]) / ray.direction[Axis];
    const double within = std::clamp(t, std::min(s, e), std::max(s, e));
    if (!range.contains(within) || !encloses_origin<Axis>(outline, ray)) return false;
    hit = {within, 0};
    return true;
  });
}

SurfacePoint flat_point(const Vec3& anchor, const Vec3& normal, double extent, const Ray& ray, const Hit& hit) {
  const Vec3 from_anchor = reject(relative_point(ray, hit, anchor), normal);
  return {anchor + from_anchor, normal, rounding_bound(32) * (magnitude(anchor) + extent)};
}

} // namespace rt
