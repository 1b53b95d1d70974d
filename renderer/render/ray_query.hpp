#pragma once

#include "renderer/integrators/integrator.hpp"
#include "renderer/render/camera_rays.hpp"
#include "renderer/shading/materials.hpp"

#include <optional>
#include <vector>

namespace rt {

/// Everything about one point where a ray hits the scene.
struct HitReport : Surface {
  double t = 0;                    ///< in multiples of the ray's direction
  double distance = 0;             ///< Euclidean, from the ray's origin
  bool enters = false;             ///< the ray goes against the geometric normal: into a solid
  std::vector<std::uint32_t> path; ///< indices into the scene's objects, then that group's members, and so on; within a
                                   ///< combination, down to the operand whose surface it is
  MaterialValues material;         ///< with patterns evaluated
  std::size_t place = 0;           ///< index of its place among `all_hits`, from 0: touching surfaces share a place
};

/// A scene compiled once, for queries about single rays. It may be used from several threads at a time. Whole pictures
/// are made by `render`, which gives the same values.
class RayQuery {
public:
  /// `threads` to build with; 0: one per core. The description need not outlive the query. Throws std::bad_alloc or
  /// std::runtime_error when the acceleration structure cannot be built.
  explicit RayQuery(const scene::Scene& scene, int threads = 0, HitRules rules = HitRules::own);

  /// The scene's camera: its rays through any point of the picture and for the samples of a pixel.
  const CameraRays& camera() const { return camera_; }

  /// The nearest hit in `range` (of t), if any: what the picture shows, where surfaces touch.
  std::optional<HitReport> nearest(const Ray& ray, const Interval& range = {}) const;
  /// All of them, front to back, at equal distances in the order of declaration.
  std::vector<HitReport> all_hits(const Ray& ray, const Interval& range = {}) const;

  /// The radiance along the ray, as the integrator computes it, before it is rounded for the film. The length of the
  /// ray's direction does not matter.
  Color radiance(const Ray& ray, IntegratorKind kind = IntegratorKind::whitted) const;

  /// The mean over the samples of a pixel, as the picture has it before it is rounded for the film.
  Color pixel(int x, int y) const {
    return pixel(x, y, [this](const Ray& ray) { return radiance(ray); });
  }
  /// The same of what `radiance_of` returns for each sample's ray.
  template <class RadianceOf>
  Color pixel(int x, int y, RadianceOf&& radiance_of) const {
    Color sum = black;
    for (int i = 0; i < sampler_.samples(); ++i) sum += radiance_of(camera_.ray({x, y}, sampler_, i));
    return sum * (1.0 / sampler_.samples());
  }

  /// The ray as it is traced: with a unit direction. One that has it, up to rounding, is not changed, so that a camera
  /// ray gives what the picture shows to the last bit.
  static Ray unit(const Ray& ray);

  const CompiledScene& scene() const { return scene_; }

private:
  HitReport report(const Ray& ray, const RayHit& hit, const Surface& surface) const;

  HitRules rules_;
  CompiledScene scene_;
  CameraRays camera_;
  Sampler sampler_;
};

} // namespace rt
