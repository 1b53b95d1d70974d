#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/integrators/rules.hpp"

#include <optional>
#include <span>

namespace rt {

struct MaterialValues;

/// A ray traced from surface to surface.
struct Walk {
  Ray ray;
  MediumStacks::List inside{};     ///< the media that contain it
  Contacts::Position contact{};    ///< where it is among touching surfaces
  bool meets_casting_only = false; ///< ignores what casts no shadow
};

/// What a walk has met, after a length.
struct Intersection {
  RayHit hit;
  double length;
  Surface surface;
};

/// Traces one ray at a time through a scene, its media and touching surfaces. Each thread has its own.
class Walker {
public:
  /// The scene must outlive it.
  explicit Walker(const CompiledScene& scene) : scene_(scene) {}

  /// Forgets the last walk.
  Walk start(const Ray& ray, std::span<const Medium> inside);
  /// The same walk as that of another walker.
  Walk start_like(const Walker& other, const Walk& walk);

  /// The nearest hit; none if it is among touching surfaces.
  RayHit nearest(const Walk& walk);
  /// What the walk meets there; nothing where it meets nothing any more.
  std::optional<Intersection> intersect(Walk& walk, RayHit nearest);
  std::optional<Intersection> next(Walk& walk) { return intersect(walk, nearest(walk)); }

  /// The transmittance of the medium over this length.
  Color left_after(const Walk& walk, double length) const;

  /// The ior before the surface divided by the ior behind it, for reflection and refraction.
  double eta(const Walk& walk, const Surface& surface, const MaterialValues& values) const;

  /// The walk continues from that surface, on either side. `is_boundary`: a different medium is behind it.
  void leave(Walk& walk, const Surface& surface, bool is_boundary, const Vec3& direction);

private:
  const CompiledScene& scene_;
  MediumStacks media_;
  Contacts contacts_;
  TraceScratch scratch_;
};

} // namespace rt
