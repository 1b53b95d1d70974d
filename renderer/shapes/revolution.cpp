#include "renderer/shapes/revolution.hpp"

#include <numbers>

namespace rt {

// Far along the axis the first rejection leaves a part along the axis that is small only relative to the height; the
// second one is of a short vector.
Vec3 radial_direction(const Vec3& from_base, const Vec3& axis) {
  const Vec3 outward = reject(from_base, axis);
  const double distance = length(outward);
  if (distance == 0) return {};
  return normalize(reject(outward / distance, axis));
}

double ends_area(double base_radius, double top_radius, bool is_open) {
  return is_open ? 0 : std::numbers::pi * (base_radius * base_radius + top_radius * top_radius);
}

} // namespace rt
