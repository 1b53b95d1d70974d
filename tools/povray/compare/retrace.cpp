#include "tools/povray/compare/retrace.hpp"

#include "renderer/render/ray_query.hpp"
#include "tools/povray/export/export_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::tools::povray {
namespace {

constexpr double near_by = 1e-9, behind = 1e-6, povray_nearest = 1e-4;

std::uint32_t number(const HitReport& hit) {
  return static_cast<std::uint32_t>(hit.order + 1);
}

Ray center(const RayQuery& query, int x, int y) {
  return query.camera().ray(x + 0.5, y + 0.5);
}

} // namespace

Retracer::Retracer(const scene::Scene& scene) : scene_(scene) {
  for (scene::Material& m : scene_.materials) m.ior = static_cast<float>(m.ior);
}
Retracer::~Retracer() = default;

const RayQuery& Retracer::query() {
  if (!query_) query_ = std::make_unique<RayQuery>(scene_, 1);
  return *query_;
}

template <class Turn>
Rgb32 Retracer::color(int x, int y, Turn&& turn) {
  const Color c =
      query().pixel(x, y, [&](const Ray& ray) { return query().radiance(turn(ray), IntegratorKind::whitted_povray); });
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

Rgb32 Retracer::color(int x, int y) {
  return color(x, y, [](const Ray& ray) { return ray; });
}

bool Retracer::is_unstable(int x, int y, const Rgb32& wanted, double tolerance) {
  for (const double size : {1e-15, 1e-14, 1e-13, 1e-12})
    for (int i = 0; i < 8; ++i) {
      const Rgb32 found = color(x, y, [&](const Ray& ray) { return beside(ray, i, size); });
      if (color_difference(found, wanted) <= tolerance) return true;
    }
  return false;
}

// The ray turned in the i-th of eight directions; in an orthographic view it is moved instead.
Ray Retracer::beside(const Ray& ray, int i, double size) const {
  const bool is_orthographic = scene_.camera.projection == scene::Projection::orthographic;
  const Vec3 least = std::abs(ray.direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalize(cross(ray.direction, least)), v = cross(ray.direction, u);
  const double angle = i * (std::numbers::pi / 4);
  const Vec3 off = (u * std::cos(angle) + v * std::sin(angle)) * (is_orthographic ? size * scene_.camera.width : size);
  return is_orthographic ? Ray{ray.origin + off, ray.direction} : Ray{ray.origin, normalize(ray.direction + off)};
}

std::uint32_t Retracer::hit_with_povray_limits(int x, int y) {
  const auto hit = query().nearest(center(query(), x, y), {povray_nearest, farthest_hit});
  return hit ? number(*hit) : 0;
}

bool Retracer::is_hit_beside(int x, int y, std::uint32_t id) {
  const Ray ray = center(query(), x, y);
  for (int i = 0; i < 8; ++i) {
    const auto hit = query().nearest(beside(ray, i, near_by));
    if ((hit ? number(*hit) : 0) == id) return true;
  }
  return false;
}

bool Retracer::is_hit_behind(int x, int y, std::uint32_t id) {
  const Ray ray = center(query(), x, y);
  const auto first = query().nearest(ray);
  if (!first) return false;
  const std::vector<HitReport> hits = query().all_hits(ray, {first->t * (1 - behind), first->t * (1 + behind)});
  return std::any_of(hits.begin(), hits.end(), [&](const HitReport& hit) { return number(hit) == id; });
}

} // namespace rt::tools::povray
