#include "tools/bench/bars/rays.hpp"

#include "renderer/render/camera_rays.hpp"

namespace rt::tools::bench {
namespace {

struct Collector : NoRecorder {
  static constexpr bool is_recording = true;
  FrameRays& rays;

  explicit Collector(FrameRays& all) : rays(all) {}
  void begin_ray(RayKind, const Ray& ray, int, const Color&) { rays.nearest.push_back(ray); }
  void light(const LightRecord& record, const Surface& surface) {
    if (!(record.cos_light > 0)) return;
    const Vec3& l = record.sample.to_light;
    const double side = dot(surface.geometric_normal, l) < 0 ? -surface.offset : surface.offset;
    rays.shadow.push_back({surface.point + surface.geometric_normal * side, l});
    rays.shadow_ends.push_back(OwnTolerances::shadow_end(record.sample.distance));
  }
};

} // namespace

FrameRays frame_rays(const CompiledScene& scene, const scene::Camera& camera, int size) {
  FrameRays rays;
  Collector collector(rays);
  Whitted<OwnTolerances, Collector> whitted(scene, collector);
  const CameraRays camera_rays(camera, {size, size});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) whitted.radiance(camera_rays.ray(x + 0.5, y + 0.5), {});
  return rays;
}

} // namespace rt::tools::bench
