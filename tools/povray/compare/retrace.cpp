#include "tools/povray/compare/retrace.hpp"

#include "tools/povray/export/export_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::tools::povray {
namespace {

constexpr double near_by = 1e-9, behind = 1e-6;
constexpr Interval povray_range{1e-4, farthest_hit};

std::uint32_t number(const HitReport& hit) {
  return static_cast<std::uint32_t>(hit.order + 1);
}

Ray center(const RayQuery& query, int x, int y) {
  return query.camera().ray(x + 0.5, y + 0.5);
}

CenterHit seen(const Ray& ray, const std::optional<HitReport>& hit) {
  if (!hit) return {};
  const Vec3& n = hit->shading_normal;
  return {number(*hit), hit->distance, dot(n, ray.direction) > 0 ? -n : n};
}

bool is_same_surface(const CenterHit& a, const CenterHit& b) {
  return a.id == b.id && (a.id == 0 || dot(a.normal, b.normal) > 0.999999);
}

} // namespace

Retracer::Retracer(const scene::Scene& scene) : scene_(scene) {
  for (scene::Material& m : scene_.materials) m.ior = static_cast<float>(m.ior);
}
Retracer::~Retracer() = default;

const RayQuery& Retracer::query(HitRules rules) {
  std::unique_ptr<RayQuery>& made = rules == HitRules::own ? own_ : povray_;
  if (!made) made = std::make_unique<RayQuery>(scene_, 1, rules);
  return *made;
}

template <class Turn>
Rgb32 Retracer::color(int x, int y, Turn&& turn) {
  const RayQuery& theirs = query(HitRules::povray);
  const Color c =
      theirs.pixel(x, y, [&](const Ray& ray) { return theirs.radiance(turn(ray), IntegratorKind::whitted_povray); });
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

// The ray rotated in the i-th of eight directions; in an orthographic view it is shifted instead.
Ray Retracer::beside(const Ray& ray, int i, double size) const {
  const bool is_orthographic = scene_.camera.projection == scene::Projection::orthographic;
  const Vec3 least = std::abs(ray.direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalize(cross(ray.direction, least)), v = cross(ray.direction, u);
  const double angle = i * (std::numbers::pi / 4);
  const Vec3 off = (u * std::cos(angle) + v * std::sin(angle)) * (is_orthographic ? size * scene_.camera.width : size);
  return is_orthographic ? Ray{ray.origin + off, ray.direction} : Ray{ray.origin, normalize(ray.direction + off)};
}

CenterHit Retracer::hit(int x, int y, HitRules rules) {
  const Ray ray = center(query(rules), x, y);
  return seen(ray, query(rules).nearest(ray, rules == HitRules::own ? Interval{} : povray_range));
}

bool Retracer::is_within_reach(int x, int y, const CenterHit& ours, const CenterHit& theirs) {
  if (ours.id != 0 && !povray_range.contains(ours.distance)) return true;
  const Ray ray = center(query(), x, y);
  const double distance = std::min(ours.distance, theirs.distance);
  const double scale = scene_.camera.projection == scene::Projection::orthographic ? scene_.camera.width : distance;
  for (const double off : {1e-6, 4e-6, 5e-7 * distance})
    for (int i = 0; i < 8; ++i) {
      const Ray other = beside(ray, i, off / scale);
      if (is_same_surface(seen(other, query().nearest(other)), theirs)) return true;
      // Where boxes touch, it may be a face that is covered by another one.
      const std::vector<HitReport> hits = query().all_hits(other, {distance - 2 * off, distance + 2 * off});
      if (std::any_of(hits.begin(), hits.end(),
                      [&](const HitReport& h) { return is_same_surface(seen(other, h), theirs); }))
        return true;
    }
  return false;
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
