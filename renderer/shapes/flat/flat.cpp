#include "renderer/shapes/flat/flat.hpp"

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

/// Due to rounding, a ray that is almost within the plane may hit it anywhere; but it does so no nearer and no farther
/// than the corners are.
double within_reach(std::span<const Vec3> outline, const Ray& ray, double t) {
  const double inverse = 1 / dot(ray.direction, ray.direction);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Vec3& corner : outline) {
    const double s = dot(corner - ray.origin, ray.direction) * inverse;
    least = std::min(least, s), most = std::max(most, s);
  }
  return std::clamp(t, least, most);
}

} // namespace

bool intersect_face(std::span<const Vec3> outline, const Vec3& normal, const Ray& ray, const Interval& range,
                    Hit& hit) {
  const double approach = dot(normal, ray.direction);
  if (approach == 0) return false;
  double t = dot(normal, outline.front() - ray.origin) / approach;
  if (approach * approach < 1e-12 * dot(ray.direction, ray.direction)) t = within_reach(outline, ray, t);
  if (!range.contains(t)) return false;
  const bool is_inside =
      along_largest(ray.direction, [&]<std::size_t Axis>() { return encloses_origin<Axis>(outline, ray); });
  if (is_inside) hit = {t, 0};
  return is_inside;
}

} // namespace rt
