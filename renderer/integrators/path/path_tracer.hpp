#pragma once

#include "renderer/integrators/integrator.hpp"
#include "renderer/integrators/path/direct_light.hpp"
#include "renderer/integrators/path/path_scene.hpp"
#include "renderer/sampling/sobol.hpp"

#include <array>
#include <atomic>
#include <span>
#include <vector>

namespace rt {

/// Traces paths from the camera, for one thread. At each surface that does not scatter in discrete directions only,
/// light is sampled in two ways: by a lamp (next event estimation), and by the path's next direction, which may hit
/// one. What both can find is weighted by the balance heuristic (E. Veach, Robust Monte Carlo Methods for Light
/// Transport Simulation, 1997, section 9.2).
class PathTracer {
public:
  /// All must outlive the tracer.
  PathTracer(const PathScene& scene, const std::atomic<bool>* stop);

  /// As `Integrator::Worker::radiance`.
  void radiance(std::span<const Ray> rays, std::span<const SampleStream> streams, const std::vector<Medium>& inside,
                std::span<Color> results);
  /// One estimate of the irradiance at a point, on the side that its unit normal points to.
  Color irradiance(const Vec3& point, const Vec3& normal, const SampleStream& stream,
                   const std::vector<Medium>& inside);
  const RayCounts& counts() const { return counts_; }

private:
  struct Path;

  Color follow(const Ray& ray, const RayHit& first, const SampleStream& stream, const std::vector<Medium>& inside);
  void continue_path(Path& path);
  bool intersect(Path& path, const RayHit& hit);
  bool add_lamp(Path& path, double end) const;
  void add_emission(Path& path, const Color& emission, const Intersection& met) const;
  bool scatter(Path& path, const ScatteringPoint& at);
  bool passes(Path& path, const ScatteringPoint& at);
  void go_straight(Path& path, const ScatteringPoint& at);
  Color direct_light(const Path& path, const ScatteringPoint& at);
  static bool survives(Path& path, double number);
  bool is_stopped() const { return stop_ && stop_->load(std::memory_order_relaxed); }

  const PathScene& path_scene_;
  const CompiledScene& scene_;
  const Lamps& lamps_;
  const std::atomic<bool>* stop_;
  Walker walker_;
  TraceScratch scratch_;
  MaterialValues values_;
  RayCounts counts_;
  DirectLighting direct_;
};

} // namespace rt
