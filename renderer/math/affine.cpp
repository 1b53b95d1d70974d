#include "renderer/math/affine.hpp"

#include "renderer/math/degrees.hpp"

#include <cmath>

namespace rt {

Affine Affine::rotating(const Vec3& axis, double degrees) {
  const Vec3 u = normalize(axis);
  const double s = sin_degrees(degrees), c = cos_degrees(degrees);
  const auto turned = [&](const Vec3& e) { return e * c + cross(u, e) * s + u * (dot(u, e) * (1 - c)); };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1}), {}};
}

Affine Affine::rotating_xyz(const Vec3& degrees) {
  return rotating({0, 0, 1}, degrees.z) * rotating({0, 1, 0}, degrees.y) * rotating({1, 0, 0}, degrees.x);
}

std::optional<Affine> inverse(const Affine& a) {
  const double det = a.determinant();
  if (det == 0 || !std::isfinite(det)) return std::nullopt;
  // The rows of the inverse are the reciprocal vectors of the columns.
  const Vec3 rx = cross(a.y, a.z) / det, ry = cross(a.z, a.x) / det, rz = cross(a.x, a.y) / det;
  Affine inv{{rx.x, ry.x, rz.x}, {rx.y, ry.y, rz.y}, {rx.z, ry.z, rz.z}, {}};
  inv.translation = -inv.vector(a.translation);
  if (!is_finite(inv.x) || !is_finite(inv.y) || !is_finite(inv.z) || !is_finite(inv.translation)) return std::nullopt;
  return inv;
}

std::optional<double> similarity_scale(const Affine& a) {
  const double scale = length(a.x);
  const double tolerance = 1e-14 * scale * scale;
  const auto differ = [&](double p, double q) { return !(std::abs(p - q) <= tolerance); };
  if (!(scale > 0) || differ(dot(a.y, a.y), dot(a.x, a.x)) || differ(dot(a.z, a.z), dot(a.x, a.x))) return std::nullopt;
  if (differ(dot(a.x, a.y), 0) || differ(dot(a.y, a.z), 0) || differ(dot(a.z, a.x), 0)) return std::nullopt;
  return scale;
}

double mean_scale(const Affine& a) {
  return std::cbrt(std::abs(a.determinant()));
}

Box3 transform_box(const Affine& a, const Box3& box) {
  if (box.is_empty()) return box;
  Box3 image{a.translation, a.translation};
  const Vec3 columns[3] = {a.x, a.y, a.z};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double m = columns[i][j];
      if (m == 0) continue; // so that 0 · ∞ does not make the box NaN
      const double p = m * box.lower[i], q = m * box.upper[i];
      image.lower[j] += std::min(p, q);
      image.upper[j] += std::max(p, q);
    }
  }
  return image;
}

} // namespace rt
