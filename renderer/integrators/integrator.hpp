#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/ray_counts.hpp"
#include "renderer/sampling/sobol.hpp"

#include <atomic>
#include <memory>
#include <span>
#include <vector>

namespace rt {

/// The maximum number of camera rays that are traced together.
inline constexpr std::size_t camera_batch_size = bvh::packet_size;

/// An algorithm for light transport. It makes a worker for each thread.
class Integrator {
public:
  class Worker {
  public:
    virtual ~Worker() = default;
    /// The radiance along each of the camera rays (unit directions), which should be coherent, `camera_batch_size` at
    /// most, and start inside these solids: `CompiledScene::around`. `streams` are the rays' random numbers; empty for
    /// an integrator that draws none.
    virtual void radiance(std::span<const Ray> rays, std::span<const SampleStream> streams,
                          const std::vector<Medium>& inside, std::span<Color> results) = 0;
    virtual const RayCounts& counts() const = 0;
  };

  virtual ~Integrator() = default;
  /// Once `stop` is set, a worker's rays end at once, and its results are meaningless.
  virtual std::unique_ptr<Worker> make_worker(const std::atomic<bool>* stop = nullptr) const = 0;
};

enum class IntegratorKind {
  whitted,
  path,
  occlusion,
  whitted_exported, ///< restricted to what an export to POV-Ray can express, for comparing with its pictures
  whitted_povray    ///< under POV-Ray's rules, for explaining where its pictures differ
};

/// The scene must outlive the integrator, and the integrator its workers.
std::unique_ptr<const Integrator> make_integrator(IntegratorKind kind, const CompiledScene& scene);

} // namespace rt
