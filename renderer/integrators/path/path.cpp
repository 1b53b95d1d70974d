#include "renderer/integrators/path/path.hpp"

#include "renderer/integrators/path/path_tracer.hpp"

namespace rt {
namespace {

class PathIntegrator final : public Integrator {
public:
  explicit PathIntegrator(const CompiledScene& scene) : scene_(scene) {}

  std::unique_ptr<Worker> make_worker(const std::atomic<bool>* stop) const override {
    return std::make_unique<PathWorker>(scene_, stop);
  }

private:
  class PathWorker final : public Worker {
  public:
    PathWorker(const PathScene& scene, const std::atomic<bool>* stop) : tracer_(scene, stop) {}

    void radiance(std::span<const Ray> rays, std::span<const SampleStream> streams, const std::vector<Medium>& inside,
                  std::span<Color> results) override {
      tracer_.radiance(rays, streams, inside, results);
    }
    const RayCounts& counts() const override { return tracer_.counts(); }

  private:
    PathTracer tracer_;
  };

  PathScene scene_;
};

} // namespace

std::unique_ptr<const Integrator> make_path(const CompiledScene& scene) {
  return std::make_unique<PathIntegrator>(scene);
}

} // namespace rt
