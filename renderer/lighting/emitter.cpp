#include "renderer/lighting/emitter.hpp"

#include "renderer/sampling/mappings.hpp"

#include <cmath>
#include <numbers>

namespace rt {
namespace {

// 1 − cos of half the angle subtended by a sphere, where the sine of that half is the root of `sine_squared`. The
// difference itself would lose the digits of a small sphere.
double cap_height(double sine_squared) {
  return sine_squared / (1 + std::sqrt(std::max(0.0, 1 - sine_squared)));
}

double seen_cap_height(const SphereGeometry& ball, const Vec3& p) {
  const Vec3 way = ball.center - p;
  return cap_height(ball.radius * ball.radius / dot(way, way));
}

} // namespace

std::optional<Emitter> Emitter::make(const LampSurface& surface, const Affine& to_scene) {
  const double area_before = std::visit([](const auto& s) { return area(s); }, surface);
  if (!std::isfinite(area_before) || !(area_before > 0)) return std::nullopt;
  if (to_scene == Affine{}) return Emitter(surface, to_scene, false);
  // A sphere that remains one is sampled by solid angle.
  if (const auto* ball = std::get_if<SphereGeometry>(&surface))
    if (const auto image = placed(*ball, to_scene)) return Emitter(*image, {}, false);
  return Emitter(surface, to_scene, true);
}

Emitter::Emitter(const LampSurface& surface, const Affine& to_scene, bool is_mapped)
    : surface_(surface), to_scene_(to_scene), is_mapped_(is_mapped),
      area_(std::visit([](const auto& s) { return area(s); }, surface)) {}

// From sampled points: a curved surface bulges out a little between them.
LightBounds Emitter::bounds(double power) const {
  constexpr int steps = 4;
  Box3 box;
  LightBounds all{.power = power, .axis = point(0.5, 0.5).normal, .cos_spread = 1};
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const AreaPoint at = point(static_cast<double>(i) / steps, static_cast<double>(j) / steps);
      box.extend(at.position);
      const double cosine = std::abs(dot(at.normal, all.axis));
      if (cosine < 1 - 1e-9) all.cos_spread = 0; // not flat
    }
  }
  all.center = box.center();
  all.radius = length(box.extent()) / 2;
  return all;
}

AreaPoint Emitter::point(double u, double v) const {
  const AreaPoint own = std::visit([&](const auto& s) { return point_by_area(s, u, v); }, surface_);
  if (!is_mapped_) return own;
  return {to_scene_.point(own.position), normalize(to_scene_.normal(own.normal))};
}

double Emitter::surface_area() const {
  return area_ * std::pow(std::abs(to_scene_.determinant()), 2.0 / 3);
}

double Emitter::enlargement(const Vec3& normal) const {
  if (!is_mapped_) return 1;
  return length(to_scene_.normal(normalize(to_scene_.transposed_vector(normal))));
}

const SphereGeometry* Emitter::ball_seen_from(const Vec3& p) const {
  const auto* ball = is_mapped_ ? nullptr : std::get_if<SphereGeometry>(&surface_);
  if (!ball) return nullptr;
  const Vec3 way = ball->center - p;
  return dot(way, way) > ball->radius * ball->radius * (1 + 1e-9) ? ball : nullptr;
}

std::optional<EmitterSample> Emitter::sample(const Vec3& p, double u, double v) const {
  if (const SphereGeometry* ball = ball_seen_from(p)) {
    const Vec3 way = ball->center - p;
    const Vec3 direction = TangentFrame(normalize(way)).vector(to_cone(u, v, seen_cap_height(*ball, p)));
    Hit hit{dot(way, direction), 0}; // it only touches, and rounding says that it does not
    intersect(*ball, {p, direction}, {}, hit);
    return EmitterSample{direction, hit.t};
  }
  const Vec3 way = point(u, v).position - p;
  const double distance = length(way);
  if (!(distance > 0)) return std::nullopt;
  return EmitterSample{way / distance, distance};
}

double Emitter::density(const Vec3& p, const Vec3& direction, const Vec3& point, const Vec3& normal) const {
  if (const SphereGeometry* ball = ball_seen_from(p)) return 1 / (2 * std::numbers::pi * seen_cap_height(*ball, p));
  const Vec3 way = point - p;
  return dot(way, way) / (area_ * enlargement(normal) * std::abs(dot(direction, normal)));
}

} // namespace rt
