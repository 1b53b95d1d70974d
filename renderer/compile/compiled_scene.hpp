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

/// A ray to a light, in a packet.
struct ShadowRay {
  Ray ray;
  Interval range;
  Color* transmittance; ///< where the result goes
};

/// A point of a surface that a ray met, in the scene's space.
struct Surface {
  Vec3 point;
  Vec3 geometric_normal; ///< unit, out of the solid (right-handed about the corners of what is flat)
  Vec3 shading_normal; ///< unit, on the same side; another where there are bumps, and on a triangle with normals of its
                       ///< own
  double offset = 0;   ///< a ray that leaves the surface starts this far off it, beyond the rounding of `point`
  std::uint64_t order = 0; ///< of the object among all in the order of declaration, from 0; a combination is one object
  std::uint32_t material_id = 0;
  std::uint32_t medium_material_id = 0; ///< the inside of the solid is this material's
  Vec3 pattern_point{};                 ///< the point as the material's patterns see it
  double ior = 1; ///< of the solid that the surface belongs to: a combination's is one for all its surfaces
};

/// A scene made ready for tracing: immutable, shared by all threads.
class CompiledScene {
public:
  /// `threads` to build with, 0: one for each core. The description need not outlive it. Throws std::bad_alloc or
  /// std::runtime_error when the acceleration structure cannot be built.
  CompiledScene(const scene::Scene& scene, int threads, bvh::Builder builder = bvh::default_builder,
                HitRules rules = HitRules::own);
  /// The same pictures, but with a tree of its own for each part of the scene's list, which is only built where the
  /// cache does not have it. `parts` are in the order of the list and do not overlap.
  CompiledScene(const scene::Scene& scene, std::span<const Part> parts, CompileCache& cache);

  /// The nearest hit in `range`; with equal distances, on the object that was declared first. Without one, the result
  /// is false.
  RayHit nearest(const Ray& ray, const Interval& range, TraceScratch& scratch) const;
  /// The fraction of light that passes along the ray: 0 if something opaque is in the interval, else the product of
  /// what the surfaces let through.
  Color transmittance(const Ray& ray, const Interval& range, TraceScratch& scratch) const;

  /// The same for up to `bvh::packet_size` rays that run close together: sooner, with the same results, one in `hits`
  /// for each ray.
  void nearest(std::span<const Ray> rays, const Interval& range, std::span<RayHit> hits, TraceScratch& scratch) const;
  /// Each ray uses the scratch of its place.
  void transmittance(std::span<const ShadowRay> rays, std::span<TraceScratch> scratch) const;

  /// The hits in the same place as `nearest`, the nearest one in `range`, or just behind it, itself among them; sorted
  /// as `all_hits`. They are kept in the scratch.
  std::span<const RayHit> hits_near(const Ray& ray, const Interval& range, const RayHit& nearest,
                                    TraceScratch& scratch) const;

  /// `transmittance` from surface to surface, where one counts only if it is more than `gap` behind the one before (or
  /// the ray's origin), as POV-Ray goes. Slow: for explaining single pixels.
  Color transmittance_by_steps(const Ray& ray, double end, double gap) const;

  /// `Surface::order` of what was hit.
  std::uint64_t order(const RayHit& hit) const;
  /// What is to be known of a hit of `ray`.
  Surface surface(const Ray& ray, const RayHit& hit) const;
  /// The material there, patterns evaluated. `scratch` holds the values where they are not constant.
  const MaterialValues& values(const Surface& surface, MaterialValues& scratch) const;

  /// All hits, from near to far; with equal distances in the order of declaration.
  std::vector<RayHit> all_hits(const Ray& ray, const Interval& range) const;
  /// The nearest hit of those that block light.
  RayHit nearest_casting(const Ray& ray, const Interval& range, TraceScratch& scratch) const;
  /// Whether what was hit blocks light: an object, or what it is part of, may cast none.
  bool casts_shadow(const RayHit& hit) const;
  /// The transparent solids that hold `p`, in the order of declaration: the list that a ray from the eye starts with.
  /// An open cylinder or cone counts by the volume that its ends would close.
  std::vector<Medium> around(const Vec3& p) const;
  /// What the medium takes of light; and whether any in the scene takes some.
  const Absorption& absorption(const Medium& medium) const;
  bool absorbs() const { return absorbs_; }
  /// Whether any material has an index of refraction that matters. Without one `around` is empty.
  bool uses_ior() const;

  /// The positions that lead to what was hit: in the scene's objects, in that one's members, and so on; in the end, for
  /// a combination, to the operand whose surface it is.
  std::vector<std::uint32_t> path(const RayHit& hit) const;

  /// What it is made of.
  const Aggregate& objects() const { return *root_; }
  const MaterialBindings& bindings() const { return *bindings_; }
  const std::vector<Light>& lights() const { return lights_; }
  /// What comes in from a direction (unit) where nothing is: the sky's light, or the background.
  Color environment(const Vec3& direction) const { return sky_ ? rt::radiance(*sky_, direction) : background_; }
  Color ambient() const { return ambient_; }
  int max_depth() const { return max_depth_; }
  /// How far away something blocks in `scene::Mode::occlusion`.
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
