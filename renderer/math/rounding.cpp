#include "renderer/math/rounding.hpp"

namespace rt {

double mapped_error(const Affine& map, const Vec3& p, double error) {
  const Vec3 terms = abs(map.x) * std::abs(p.x) + abs(map.y) * std::abs(p.y) + abs(map.z) * std::abs(p.z);
  const double rounding = rounding_bound(4) * length(terms + abs(map.translation));
  // The root of the sum of all squares is at least the factor by which the map stretches any vector.
  const double stretch = std::sqrt(dot(map.x, map.x) + dot(map.y, map.y) + dot(map.z, map.z));
  return rounding + stretch * error;
}

} // namespace rt
