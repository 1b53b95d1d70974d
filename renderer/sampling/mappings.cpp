#include "renderer/sampling/mappings.hpp"

#include "renderer/math/elementary.hpp"

#include <cmath>
#include <numbers>

namespace rt {

Vec2 to_disc(double u, double v) {
  const double a = 2 * u - 1, b = 2 * v - 1;
  if (a == 0 && b == 0) return {};
  constexpr double eighth = std::numbers::pi / 4;
  if (std::abs(a) > std::abs(b)) {
    const SineCosine s = sine_cosine_near_zero(eighth * (b / a));
    return {a * s.cosine, a * s.sine};
  }
  const SineCosine s = sine_cosine_near_zero(eighth * (a / b));
  return {b * s.sine, b * s.cosine};
}

Vec3 to_cosine_hemisphere(double u, double v) {
  const Vec2 d = to_disc(u, v);
  return {d.x, d.y, std::sqrt(std::max(0.0, 1 - d.x * d.x - d.y * d.y))};
}

// A ring of squared radius q about the pole, on a cap of height `height`·q.
Vec3 to_cone(double u, double v, double height) {
  const Vec2 d = to_disc(u, v);
  const double drop = height * (d.x * d.x + d.y * d.y);
  const double stretch = std::sqrt(height * (2 - drop));
  return {d.x * stretch, d.y * stretch, 1 - drop};
}

Vec3 to_sphere(double u, double v) {
  return to_cone(u, v, 2);
}

Vec3 to_triangle(double u, double v) {
  double b, c;
  if (u < v)
    b = u / 2, c = v - b;
  else
    c = v / 2, b = u - c;
  return {1 - b - c, b, c};
}

TangentFrame::TangentFrame(const Vec3& unit_z) : z_(unit_z) {
  const double sign = std::copysign(1.0, z_.z), a = -1 / (sign + z_.z), b = z_.x * z_.y * a;
  x_ = {1 + sign * z_.x * z_.x * a, sign * b, -sign * z_.x};
  y_ = {b, sign + z_.y * z_.y * a, -z_.y};
}

} // namespace rt
