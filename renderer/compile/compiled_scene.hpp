#pragma once

#include "renderer/bvh/bvh.hpp"
#include "renderer/compile/hit_rules.hpp"
#include "renderer/compile/ray_hit.hpp"
#include "renderer/shading/absorption.hpp"
#include "renderer/shading/lights.hpp"
#include "renderer/shading/media.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rt {
namespace scene {
struct Scene;
}

class CompileCache;
struct CompiledObjects;
class MaterialBindings;
struct MaterialValues;
struct Part;
struct Slack;

/// A shadow ray of a packet.
struct ShadowRay {
  Ray ray;
  Interval range;
  Color* transmittance; ///< where to store the result
};

/// The intersection of a ray with a surface, in scene space.
struct Surface : SurfacePoint {
  Vec3 shading_normal; ///< unit, on the same side; differs where there are bumps, and on a triangle with vertex normals
  std::uint64_t order = 0; ///< of the object among all, in the order of declaration from 0; a combination is one object
  std::uint32_t material_id = 0;
  std::uint32_t medium_material_id = 0; ///< the material of the solid's interior
  Vec3 pattern_point{};                 ///< the point at which the material's patterns are evaluated
  double ior = 1; ///< of the solid that the surface belongs to: a combination has one for all its surfaces
};

/// A scene prepared for tracing: immutable, shared by all threads.
class CompiledScene {
public:
  /// `threads` to build with; 0: one per core. The description need not outlive it. Throws std::bad_alloc or
  /// std::runtime_error when the acceleration structure cannot be built.
  CompiledScene(const scene::Scene& scene, int threads, bvh::Builder builder = bvh::default_builder,
                HitRules rules = HitRules::own);
  /// The same pictures, but with a separate tree for each part of the scene's list, which is built only if the cache
  /// does not have it. `parts` are in list order and do not overlap.
  CompiledScene(const scene::Scene& scene, std::span<const Part> parts, CompileCache& cache);

  /// The nearest hit in `range`; at equal distances, on the object declared first. Converts to false if there is
  /// none.
  RayHit nearest(const Ray& ray, const Interval& range, TraceScratch& scratch) const;
  /// The transmittance along the ray: 0 if anything opaque is in the interval, else the product of the surfaces'
  /// transmittances.
  Color transmittance(const Ray& ray, const Interval& range, TraceScratch& scratch) const;

  /// The same for up to `bvh::packet_size` coherent rays: faster, with the same results, one in `hits` for each
  /// ray.
  void nearest(std::span<const Ray> rays, const Interval& range, std::span<RayHit> hits, TraceScratch& scratch) const;
  /// Each ray uses the scratch at its index.
  void transmittance(std::span<const ShadowRay> rays, std::span<TraceScratch> scratch) const;

  /// The hits in the same place as `nearest`, the nearest one in `range`, or just behind it, including itself; sorted
  /// like `all_hits`. They are kept in the scratch.
  std::span<const RayHit> hits_near(const Ray& ray, const Interval& range, const RayHit& nearest,
                                    TraceScratch& scratch) const;

  /// `transmittance` from surface to surface, as POV-Ray computes it: one counts only if it is more than `gap` behind
  /// the one before (or the ray's origin). Slow: for explaining single pixels.
  Color transmittance_by_steps(const Ray& ray, double end, double gap) const;

  /// `Surface::order` of the object that was hit.
  std::uint64_t order(const RayHit& hit) const;
  /// The surface at a hit of `ray`.
  Surface surface(const Ray& ray, const RayHit& hit) const;
  /// The material at that point, patterns evaluated. `scratch` holds the values if they are not constant.
  const MaterialValues& values(const Surface& surface, MaterialValues& scratch) const;

  /// All hits, front to back; at equal distances in the order of declaration.
  std::vector<RayHit> all_hits(const Ray& ray, const Interval& range) const;
  /// The nearest hit with an object that casts shadows.
  RayHit nearest_casting(const Ray& ray, const Interval& range, TraceScratch& scratch) const;
  /// Whether the object that was hit casts shadows: it, or a group it is part of, may cast none.
  bool casts_shadow(const RayHit& hit) const;
  /// The transparent solids that contain `p`, in the order of declaration: the media that a camera ray starts in. An
  /// open cylinder or cone counts as if its ends were closed.
  std::vector<Medium> around(const Vec3& p) const;
  /// The medium's absorption; and whether any medium in the scene absorbs.
  const Absorption& absorption(const Medium& medium) const;
  bool absorbs() const { return absorbs_; }
  /// Whether any material has an index of refraction that matters. If none has, `around` is empty.
  bool uses_ior() const;

  /// The indices that lead to what was hit: into the scene's objects, then its members, and so on; finally, for a
  /// combination, to the operand whose surface it is.
  std::vector<std::uint32_t> path(const RayHit& hit) const;

  /// The root aggregate.
  const Aggregate& objects() const { return *root_; }
  const MaterialBindings& bindings() const { return *bindings_; }
  const std::vector<Light>& lights() const { return lights_; }
  /// The radiance from a direction (unit) in which there is no object: the sky's, or the background.
  Color environment(const Vec3& direction) const { return sky_ ? rt::radiance(*sky_, direction) : background_; }
  Color ambient() const { return ambient_; }
  int max_depth() const { return max_depth_; }
  /// The greatest distance at which something occludes in `scene::Mode::occlusion`.
  double reach() const { return reach_; }
  double min_weight() const { return min_weight_; }

private:
  void add_lights(const scene::Scene& scene);
  Slack slack(const Ray& ray) const;
  void inspect(const Ray& ray, const Interval& range, TraceScratch& scratch, std::vector<RayHit>& hits) const;

  std::shared_ptr<const bvh::Device> device_;
  std::shared_ptr<const MaterialBindings> bindings_;
  std::shared_ptr<const CompiledObjects> objects_;
  const Aggregate* root_; // of the objects
  std::vector<Light> lights_;
  std::optional<SkyEmitter> sky_;
  Color background_, ambient_;
  int max_depth_;
  double min_weight_;
  double reach_;
  bool absorbs_ = false;
};

} // namespace rt
