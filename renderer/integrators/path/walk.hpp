#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/integrators/rules.hpp"

#include <optional>
#include <span>

namespace rt {

struct MaterialValues;

/// A ray on its way from surface to surface.
struct Walk {
  Ray ray;
  MediumStacks::List inside{};     ///< the solids that it is inside of
  Contacts::Position contact{};    ///< where it is among surfaces that touch
  bool meets_casting_only = false; ///< not what casts no shadow
};

/// What a walk has met, after a length.
struct Intersection {
  RayHit hit;
  double length;
  Surface surface;
};

/// Leads one ray at a time through a scene, its media and surfaces that touch. Each thread has its own.
class Walker {
public:
  /// The scene must outlive it.
  explicit Walker(const CompiledScene& scene) : scene_(scene) {}

  /// Forgets the last walk.
  Walk start(const Ray& ray, std::span<const Medium> inside);
  /// The same walk as that of another walker.
  Walk start_like(const Walker& other, const Walk& walk);

  /// The nearest hit on the way: none among surfaces that touch.
  RayHit nearest(const Walk& walk);
  /// What the walk meets there; nothing where it meets nothing any more.
  std::optional<Intersection> intersect(Walk& walk, RayHit nearest);
  std::optional<Intersection> next(Walk& walk) { return intersect(walk, nearest(walk)); }

  /// What the medium leaves of light on a way of this length.
  Color left_after(const Walk& walk, double length) const;

  /// The ior behind the surface that was met by the ior before it, as its mirror and what passes it ask.
  double eta(const Walk& walk, const Surface& surface, const MaterialValues& values) const;

  /// The walk goes on from that surface, on either side. `is_boundary`: what is behind it is another medium.
  void leave(Walk& walk, const Surface& surface, bool is_boundary, const Vec3& direction);

private:
  const CompiledScene& scene_;
  MediumStacks media_;
  Contacts contacts_;
  TraceScratch scratch_;
};

} // namespace rt
