#pragma once

#include "renderer/integrators/interiors.hpp"
#include "renderer/lights.hpp"
#include "renderer/materials.hpp"
#include "renderer/math/ray.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace rt {

/// Rays traced so far.
struct RayCounts {
  std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0;
};

/// Where a ray meets the scene: enough to work out the rest (`Traceable::surface`) for the one hit that counts.
struct RayHit {
  double t = std::numeric_limits<double>::max();
  std::uint32_t kind = 0;
  std::uint32_t index = 0;
  std::uint32_t part = 0;
};

/// The surface at a hit, in the scene's space.
struct Surface {
  Vec3 point;
  Vec3 geometric_normal;   ///< unit, out of the solid
  Vec3 shading_normal;     ///< unit; the same but on a triangle with normals of its own
  double offset = 0;       ///< a ray that leaves the surface starts this far off it, beyond the rounding of `point`
  std::uint64_t order = 0; ///< of the object: the number of its place in the order of declaration, from 0
  std::uint32_t material = 0;
  Vec3 pattern_point;         ///< the point in the space of the material's patterns
  std::uint64_t interior = 0; ///< the solid it belongs to
  double ior = 1;             ///< of that solid
};

/// Storage that tracing needs while it runs: each thread has its own.
struct TraceScratch {};

/// A scene made ready for tracing: immutable, shared by all threads.
class Traceable {
public:
  /// Throws std::bad_alloc or std::runtime_error when the acceleration structure cannot be built.
  Traceable(const scene::Scene& scene, int threads);
  ~Traceable();

  bool nearest(const Ray& ray, double t_min, RayHit& hit, TraceScratch& scratch) const;
  Surface surface(const Ray& ray, const RayHit& hit) const;
  const MaterialValues& values(const Surface& surface, MaterialValues& scratch) const {
    if (!materials_.has_patterns(surface.material)) return materials_.constant(surface.material);
    return scratch = materials_.at(surface.material, surface.pattern_point);
  }
  Color transmittance(const Ray& ray, double from, double to, TraceScratch& scratch) const;

  const std::vector<Lamp>& lamps() const { return lamps_; }
  Color background() const { return background_; }
  Color ambient() const { return ambient_; }
  int max_depth() const { return max_depth_; }
  std::uint64_t primitive_count() const;

private:
  struct Geometry;
  std::unique_ptr<Geometry> geometry_;
  Materials materials_;
  std::vector<Lamp> lamps_;
  Color background_, ambient_;
  int max_depth_;
};

} // namespace rt
