#include "tools/povray/retrace.hpp"

#include "renderer/camera.hpp"
#include "renderer/integrators/whitted.hpp"
#include "renderer/traceable.hpp"
#include "tools/povray/export_parts.hpp"

#include <cmath>
#include <numbers>

namespace rt::tools::povray {
namespace {

constexpr double beside = 1e-9, behind = 1e-6;

} // namespace

struct Retracer::Tracing {
  explicit Tracing(const scene::Scene& scene)
      : traceable(scene, 1), camera(scene.camera, scene.size), side(static_cast<int>(std::lround(std::sqrt(scene.samples)))),
        whitted(traceable, recorder) {}

  Ray center(int x, int y) const { return camera.ray(x + 0.5, y + 0.5); }

  std::uint32_t id(const Ray& ray, double from, double to = std::numeric_limits<double>::max()) {
    const RayHit hit = traceable.nearest(ray, {from, to}, scratch);
    if (!hit) return 0;
    return static_cast<std::uint32_t>(traceable.surface(ray, hit).order + 1);
  }

  Traceable traceable;
  CameraRays camera;
  int side;
  NoRecorder recorder;
  Whitted<PovrayTolerances> whitted;
  TraceScratch scratch;
};

Retracer::Retracer(const scene::Scene& scene) : scene_(scene) {}
Retracer::~Retracer() = default;

Retracer::Tracing& Retracer::tracing() {
  if (!tracing_) tracing_ = std::make_unique<Tracing>(scene_);
  return *tracing_;
}

Rgb32 Retracer::color(int x, int y) {
  Tracing& t = tracing();
  Color sum;
  for (int sample = 0; sample < t.side * t.side; ++sample) sum += t.whitted.radiance(t.camera.ray(x, y, sample, t.side), {});
  sum = sum * (1.0 / (t.side * t.side));
  return {static_cast<float>(sum.r), static_cast<float>(sum.g), static_cast<float>(sum.b)};
}

std::uint32_t Retracer::hit_with_povray_limits(int x, int y) {
  return tracing().id(tracing().center(x, y), PovrayTolerances::nearest, farthest_hit);
}

bool Retracer::is_hit_beside(int x, int y, std::uint32_t id) {
  Tracing& t = tracing();
  const Ray ray = t.center(x, y);
  const Vec3 across = t.camera.ray(x + 1.5, y + 0.5).direction - ray.direction;
  const bool is_orthographic = length(across) == 0;
  const Vec3 least = std::abs(ray.direction.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalize(cross(ray.direction, least)), v = cross(ray.direction, u);
  const double reach = is_orthographic ? beside * std::max(1.0, length(ray.origin)) : beside;
  for (int i = 0; i < 8; ++i) {
    const double a = i * (std::numbers::pi / 4);
    const Vec3 off = (u * std::cos(a) + v * std::sin(a)) * reach;
    const Ray other = is_orthographic ? Ray{ray.origin + off, ray.direction} : Ray{ray.origin, normalize(ray.direction + off)};
    if (t.id(other, 0) == id) return true;
  }
  return false;
}

bool Retracer::is_hit_behind(int x, int y, std::uint32_t id) {
  Tracing& t = tracing();
  const Ray ray = t.center(x, y);
  const RayHit hit = t.traceable.nearest(ray, {}, t.scratch);
  if (!hit) return false;
  const double end = hit.t * (1 + behind);
  for (double from = hit.t; from <= end;) {
    const RayHit next = t.traceable.nearest(ray, {from, end}, t.scratch);
    if (!next) return false;
    if (t.traceable.surface(ray, next).order + 1 == id) return true;
    from = next.t;
  }
  return false;
}

} // namespace rt::tools::povray
