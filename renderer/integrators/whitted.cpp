#include "renderer/integrators/whitted.hpp"

namespace rt {
namespace {

template <class Rules>
class WhittedIntegrator final : public Integrator {
public:
  explicit WhittedIntegrator(const CompiledScene& scene) : scene_(scene) {}

  std::unique_ptr<Worker> make_worker(const std::atomic<bool>* stop) const override {
    return std::make_unique<WhittedWorker>(scene_, stop);
  }

private:
  class WhittedWorker final : public Worker {
  public:
    WhittedWorker(const CompiledScene& scene, const std::atomic<bool>* stop) : tracer_(scene, recorder_, stop) {}

    void radiance(std::span<const Ray> rays, std::span<const SampleStream>, const std::vector<Medium>& inside,
                  std::span<Color> results) override {
      tracer_.radiance(rays, inside, results);
    }
    const RayCounts& counts() const override { return tracer_.counts(); }

  private:
    NoRecorder recorder_;
    Whitted<Rules> tracer_;
  };

  const CompiledScene& scene_;
};

} // namespace

std::unique_ptr<const Integrator> make_whitted(const CompiledScene& scene) {
  return std::make_unique<WhittedIntegrator<OwnRules>>(scene);
}

std::unique_ptr<const Integrator> make_whitted_exported(const CompiledScene& scene) {
  return std::make_unique<WhittedIntegrator<ExportedRules>>(scene);
}

std::unique_ptr<const Integrator> make_whitted_povray(const CompiledScene& scene) {
  return std::make_unique<WhittedIntegrator<PovrayRules>>(scene);
}

} // namespace rt
