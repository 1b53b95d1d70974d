#include "tools/bench/bars/rays.hpp"

#include "renderer/render/camera_rays.hpp"

namespace rt::tools::bench {
namespace {

struct Collector : NoRecorder {
  FrameRays& rays;

  explicit Collector(FrameRays& all) : rays(all) {}
  void begin_ray(RayKind, const Ray& ray, int, const Color&) { rays.nearest.push_back(ray); }
  void light(const LightRecord& record, const Surface& surface) {
    if (!(record.cos_light > 0)) return;
    rays.shadow.push_back(OwnRules::leave(surface, record.sample.to_light));
    rays.shadow_ends.push_back(OwnRules::shadow_range(record.sample.distance).upper);
  }
};

} // namespace

FrameRays frame_rays(const CompiledScene& scene, const scene::Camera& camera, int size) {
  FrameRays rays;
  Collector collector(rays);
  Whitted<OwnRules, Collector> whitted(scene, collector);
  const CameraRays camera_rays(camera, {size, size});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) whitted.radiance(camera_rays.ray(x + 0.5, y + 0.5), {});
  return rays;
}

} // namespace rt::tools::bench
