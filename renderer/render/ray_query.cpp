#include "renderer/render/ray_query.hpp"

#include "renderer/compile/touching.hpp"

#include <cmath>

namespace rt {

RayQuery::RayQuery(const scene::Scene& scene, int threads, HitRules rules)
    : rules_(rules), scene_(scene, threads, bvh::default_builder, rules), camera_(scene.camera, scene.size),
      sampler_(scene::whitted_samples(scene)) {}

std::optional<HitReport> RayQuery::nearest(const Ray& ray, const Interval& range) const {
  TraceScratch scratch;
  if (rules_ == HitRules::own) {
    const auto first = first_surface(scene_, ray, range, scratch);
    if (!first) return std::nullopt;
    return report(ray, first->hit, first->surface);
  }
  const RayHit hit = scene_.nearest(ray, range, scratch);
  if (!hit) return std::nullopt;
  return report(ray, hit, scene_.surface(ray, hit));
}

std::vector<HitReport> RayQuery::all_hits(const Ray& ray, const Interval& range) const {
  std::vector<HitReport> reports;
  std::size_t first = 0; // in its place
  for (const RayHit& hit : scene_.all_hits(ray, range)) {
    HitReport& r = reports.emplace_back(report(ray, hit, scene_.surface(ray, hit)));
    if (reports.size() == 1) continue;
    r.place = reports[first].place;
    if (touch(r, reports[first])) continue;
    ++r.place;
    first = reports.size() - 1;
  }
  return reports;
}

Color RayQuery::radiance(const Ray& ray, IntegratorKind kind) const {
  const Ray traced = unit(ray);
  const SampleStream stream;
  Color result;
  make_integrator(kind, scene_)
      ->make_worker()
      ->radiance({&traced, 1}, {&stream, 1}, scene_.around(ray.origin), {&result, 1});
  return result;
}

Ray RayQuery::unit(const Ray& ray) {
  const double squared = dot(ray.direction, ray.direction);
  if (std::abs(squared - 1) <= 1e-15) return ray;
  return {ray.origin, normalize(ray.direction)};
}

HitReport RayQuery::report(const Ray& ray, const RayHit& hit, const Surface& surface) const {
  HitReport report;
  static_cast<Surface&>(report) = surface;
  report.t = hit.t;
  report.distance = hit.t * length(ray.direction);
  report.enters = dot(report.normal, ray.direction) < 0;
  report.path = scene_.path(hit);
  MaterialValues scratch;
  report.material = scene_.values(report, scratch);
  return report;
}

} // namespace rt
