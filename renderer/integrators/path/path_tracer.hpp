#pragma once

#include "renderer/integrators/integrator.hpp"
#include "renderer/integrators/path/direct_light.hpp"
#include "renderer/integrators/path/lobes.hpp"
#include "renderer/lighting/lamps.hpp"
#include "renderer/sampling/sobol.hpp"

#include <array>
#include <atomic>
#include <span>
#include <vector>

namespace rt {

/// Follows paths from the camera, for one thread. At each surface that scatters in all directions, light is looked for
/// in two ways: a lamp is asked (next event), and the path goes on and may find one by chance. What both can find is
/// weighted by the balance heuristic (E. Veach, Robust Monte Carlo Methods for Light Transport Simulation, 1997,
/// section 9.2).
class PathTracer {
public:
  /// All must outlive the tracer.
  PathTracer(const CompiledScene& scene, const Lamps& lamps, const std::atomic<bool>* stop);

  /// As `Integrator::Worker::radiance`.
  void radiance(std::span<const Ray> rays, std::span<const SampleStream> streams, const std::vector<Medium>& inside,
                std::span<Color> results);
  /// One estimate of the light that falls on a small surface at a point, from the side that its unit normal points to.
  Color irradiance(const Vec3& point, const Vec3& normal, const SampleStream& stream,
                   const std::vector<Medium>& inside);
  const RayCounts& counts() const { return counts_; }

private:
  struct Path;
  struct Vertex;

  Color follow(const Ray& ray, const RayHit& first, const SampleStream& stream, const std::vector<Medium>& inside);
  void go_on(Path& path);
  bool meet(Path& path, const RayHit& hit);
  RayHit next_hit(const Path& path);
  bool add_lamp(Path& path, double end) const;
  void add_emission(Path& path, const Vertex& at, const RayHit& hit) const;
  bool scatter(Path& path, const Vertex& at);
  bool passes(Path& path, const Vertex& at);
  Color direct_light(const Path& path, const Vertex& at, const Lobes& l, double share);
  void go_anywhere(Path& path, const Vertex& at, double share, const std::array<double, 4>& numbers);
  void go_through(Path& path, const Vertex& at, const Lobes& l);
  bool survives(Path& path, double number) const;
  Lobes lobes_at(const Path& path, const Vertex& at) const;
  bool is_stopped() const { return stop_ && stop_->load(std::memory_order_relaxed); }

  const CompiledScene& scene_;
  const Lamps& lamps_;
  const std::atomic<bool>* stop_;
  MediumStacks media_;
  TraceScratch scratch_;
  MaterialValues values_;
  RayCounts counts_;
  DirectLighting direct_;
};

} // namespace rt
