#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/ray_counts.hpp"
#include "renderer/sampling/sobol.hpp"

#include <atomic>
#include <memory>
#include <span>
#include <vector>

namespace rt {

/// How many of the camera's rays are traced together at most.
inline constexpr std::size_t camera_batch_size = bvh::packet_size;

/// A way to follow light through a scene. It makes a worker for each thread.
class Integrator {
public:
  class Worker {
  public:
    virtual ~Worker() = default;
    /// The light that comes in along each of the camera's rays (unit directions), which should run close together,
    /// `camera_batch_size` at most, and start inside of these solids: `CompiledScene::around`. `streams` are the rays'
    /// random numbers; who draws none takes an empty one.
    virtual void radiance(std::span<const Ray> rays, std::span<const SampleStream> streams,
                          const std::vector<Medium>& inside, std::span<Color> results) = 0;
    virtual const RayCounts& counts() const = 0;
  };

  virtual ~Integrator() = default;
  /// Once `stop` is set, a worker's rays end at once, and its results mean nothing any more.
  virtual std::unique_ptr<Worker> make_worker(const std::atomic<bool>* stop = nullptr) const = 0;
};

enum class IntegratorKind {
  whitted,
  path,
  occlusion,
  whitted_exported, ///< in what an export to POV-Ray can say, for comparing with its pictures
  whitted_povray    ///< under POV-Ray's rules, for explaining where its pictures differ
};

/// The scene must outlive the integrator, and that its workers.
std::unique_ptr<const Integrator> make_integrator(IntegratorKind kind, const CompiledScene& scene);

} // namespace rt
