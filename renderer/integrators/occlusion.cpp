#include "renderer/integrators/occlusion.hpp"

#include "renderer/compile/touching.hpp"
#include "renderer/integrators/rules.hpp"
#include "renderer/math/static_vector.hpp"
#include "renderer/sampling/mappings.hpp"

#include <optional>

namespace rt {
namespace {

class OcclusionWorker final : public Integrator::Worker {
public:
  explicit OcclusionWorker(const CompiledScene& scene) : scene_(scene) {}

  void radiance(std::span<const Ray> rays, std::span<const SampleStream> streams, const std::vector<Medium>&,
                std::span<Color> results) override {
    counts_.camera += rays.size();
    StaticVector<RayHit, camera_batch_size> hits;
    for (std::size_t i = 0; i < rays.size(); ++i) hits.add([] { return RayHit{}; });
    scene_.nearest(rays, OwnRules::hit_range(), hits, scratch_);
    for (std::size_t i = 0; i < rays.size(); ++i) results[i] = is_open(rays[i], hits[i], streams[i]) ? white : black;
  }
  const RayCounts& counts() const override { return counts_; }

private:
  bool is_open(const Ray& ray, const RayHit& hit, const SampleStream& stream) {
    const std::optional<Surface> surface = seen(ray, hit);
    if (!surface) return true;
    const Vec3& n = surface->shading_normal;
    const auto numbers = stream.group(first_free_group);
    const TangentFrame frame(dot(n, ray.direction) > 0 ? -n : n);
    const Vec3 direction = normalize(frame.vector(to_cosine_hemisphere(numbers[0], numbers[1])));
    ++counts_.shadow;
    return !scene_.nearest_casting(OwnRules::leave(*surface, direction), {0, scene_.reach()}, scratch_);
  }

  std::optional<Surface> seen(const Ray& ray, const RayHit& hit) {
    if (!hit) return std::nullopt;
    if (!hit.is_contested) return scene_.surface(ray, hit);
    const auto first = first_surface(scene_, ray, OwnRules::hit_range(), scratch_);
    return first ? std::optional(first->surface) : std::nullopt;
  }

  const CompiledScene& scene_;
  TraceScratch scratch_;
  RayCounts counts_;
};

class OcclusionIntegrator final : public Integrator {
public:
  explicit OcclusionIntegrator(const CompiledScene& scene) : scene_(scene) {}

  std::unique_ptr<Worker> make_worker(const std::atomic<bool>*) const override {
    return std::make_unique<OcclusionWorker>(scene_);
  }

private:
  const CompiledScene& scene_;
};

} // namespace

std::unique_ptr<const Integrator> make_occlusion(const CompiledScene& scene) {
  return std::make_unique<OcclusionIntegrator>(scene);
}

} // namespace rt
