#pragma once

#include "renderer/compile/touching.hpp"
#include "renderer/shading/media.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// One of the surfaces of a contact, with the stack of media that contain a ray before and behind it.
struct ContactSurface : MetSurface {
  Ray ray; ///< the ray that hit the contact: `hit` is along it
  MediumStacks::List before, behind;
};

/// The touching surfaces hit by the rays of one ray tree. A contact is a single event: all solids left and entered
/// there are crossed in one place, surface by surface, in an order that depends neither on rounding nor on the order of
/// declaration. First comes the innermost of the solids that are entered, then those around it, then those that are
/// left, the outermost first. So only one of the surfaces separates two media, that before the contact and that behind
/// it; the others are crossed unbent, as where solids overlap by next to nothing.
///
/// A ray may turn back within a contact, at a mirror: then it crosses in reverse what it has crossed.
class Contacts {
public:
  /// Where a ray is: in a contact, ahead of one of its surfaces, or in none.
  struct Position {
    std::uint32_t begin = 0, count = 0; ///< of the contact's surfaces
    std::uint32_t next = 0;             ///< among them, the one that is hit next
    bool is_backward = false;           ///< the ray crosses them from last to first

    bool is_inside() const { return count > 0; }
  };

  /// Finds out what a ray that is inside of `inside` meets at its nearest hit in `range`, which is contested. Surfaces
  /// that were stored from `free` on are forgotten. The result has a count of 0 where all that is entered there is left
  /// at once: the ray goes on behind `end`. With a count of 1 there is one surface that matters, and no contact.
  Position intersect(const CompiledScene& scene, const Ray& ray, const Interval& range, const RayHit& nearest,
                     MediumStacks::List inside, MediumStacks& media, std::uint32_t free, TraceScratch& scratch,
                     Touching which = Touching::all);
  /// All that is where `intersect` looked, also what does not matter.
  const std::vector<MetSurface>& met() const { return touching_.surfaces; }
  /// The ray's t at the last of them.
  double end() const { return touching_.end(); }

  const ContactSurface& surface(const Position& p) const { return surfaces_[p.begin + p.next]; }
  /// The media around the ray behind the surface.
  MediumStacks::List behind(const Position& p) const { return p.is_backward ? surface(p).before : surface(p).behind; }
  MediumTransition transition(const Position& p, const MediumStacks& media) const;

  /// Where a ray is that leaves the surface in this direction.
  Position after(const Position& p, const Vec3& direction) const;
  /// The transmittance of the contact's other surfaces on that side along the direction: those that cast shadows.
  Color transmittance(const CompiledScene& scene, const Position& p, const Vec3& direction) const;

  /// A ray leaves the contact, inside `list`, which it then owns if the contact's lists were its own.
  MediumStacks::List leave(const Position& p, MediumStacks::List list, MediumStacks& media,
                           std::uint32_t owned_from) const;

private:
  std::vector<ContactSurface> surfaces_;
  TouchingSurfaces touching_;
};

} // namespace rt
