#pragma once

#include "renderer/compile/touching.hpp"
#include "renderer/shading/media.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// One of the surfaces of a contact, with the solids that a ray is inside of before and behind it.
struct ContactSurface : MetSurface {
  Ray ray; ///< that met the contact: `hit` is along it
  MediumStacks::List before, behind;
};

/// The surfaces that touch where rays of one tree of rays meet them. A contact is an event of its own: all that is left
/// there and all that is entered is passed in one place, surface by surface, in an order that neither rounding nor the
/// order of declaration decides. First comes the innermost of the solids that are entered, then what is entered outside
/// of it, then what is left, the outermost first. So only one of the surfaces is between two media, the one before the
/// contact and the one behind it; the others are crossed unbent, as where solids overlap by next to nothing.
///
/// A ray may turn round within a contact, at a mirror: then it meets in reverse what it has passed.
class Contacts {
public:
  /// Where a ray is: in a contact, ahead of one of its surfaces, or in none.
  struct Position {
    std::uint32_t begin = 0, count = 0; ///< of the contact's surfaces
    std::uint32_t next = 0;             ///< among them, the one that is met next
    bool is_backward = false;           ///< the ray passes them from the last to the first

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
  /// The ray's t at the last of that.
  double end() const { return touching_.end(); }

  const ContactSurface& surface(const Position& p) const { return surfaces_[p.begin + p.next]; }
  /// The solids around the ray behind the surface.
  MediumStacks::List behind(const Position& p) const { return p.is_backward ? surface(p).before : surface(p).behind; }
  MediumTransition transition(const Position& p, const MediumStacks& media) const;

  /// Where a ray is that leaves the surface in this direction.
  Position after(const Position& p, const Vec3& direction) const;
  /// What the contact's other surfaces on that side let by of the light along the direction: those that cast shadows.
  Color transmittance(const CompiledScene& scene, const Position& p, const Vec3& direction) const;

  /// A ray leaves the contact, inside of `list`, which becomes one that it owns if the contact's lists were its own.
  MediumStacks::List leave(const Position& p, MediumStacks::List list, MediumStacks& media,
                           std::uint32_t owned_from) const;

private:
  std::vector<ContactSurface> surfaces_;
  TouchingSurfaces touching_;
};

} // namespace rt
