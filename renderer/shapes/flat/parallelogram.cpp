#include "renderer/shapes/flat/parallelogram.hpp"

#include <limits>

namespace rt {

Parallelogram parallelogram_around(std::span<const Vec3> outline, const Vec3& normal) {
  const Vec3 first = outline[1] - outline[0];
  if (outline.size() == 4) {
    const Vec3 last = outline[3] - outline[0], gap = outline[2] - outline[0] - first - last;
    if (length(gap) <= 1e-12 * (length(first) + length(last))) return {outline[0], first, last, normal};
  }
  const Vec3 u = normalize(first), v = cross(normal, u);
  constexpr double far = std::numeric_limits<double>::max();
  double least_u = far, most_u = -far, least_v = far, most_v = -far;
  for (const Vec3& point : outline) {
    const Vec3 way = point - outline[0];
    least_u = std::min(least_u, dot(way, u)), most_u = std::max(most_u, dot(way, u));
    least_v = std::min(least_v, dot(way, v)), most_v = std::max(most_v, dot(way, v));
  }
  return {outline[0] + u * least_u + v * least_v, u * (most_u - least_u), v * (most_v - least_v), normal};
}

double area(const Parallelogram& face) {
  return length(cross(face.edge_u, face.edge_v));
}

AreaPoint point_by_area(const Parallelogram& face, double u, double v) {
  return {face.corner + face.edge_u * u + face.edge_v * v, face.normal};
}

} // namespace rt
