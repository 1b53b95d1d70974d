#pragma once

#include "renderer/math/affine.hpp"
#include "renderer/math/interval.hpp"
#include "renderer/math/ray.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

/// What every shape's geometry provides. `G` stands for SphereGeometry, PlaneGeometry and so on: the shape derived from
/// its description, in object space or placed in the scene's space.
///
///     G geometry(const scene::S&);                           // the description must be valid
///     std::optional<G> placed(const G&, const Affine&);      // in the space the map leads to, if still a G there
///     Box3 bounds(const G&, const Affine& map = {});         // of the mapped shape, up to rounding; possibly infinite
///     bool intersect(const G&, const Ray&, const Interval&, Hit&);   // the nearest crossing in the interval
///     SurfacePoint surface_point(const G&, const Ray&, const Hit&);  // that crossing's point and normal
///
/// and for solids
///
///     bool is_solid(const G&);                               // false: open, it has no inside. A shape that never has
///                                                            // one gives std::false_type, and neither of the next two
///     Crossings crossings(const G&, const Ray&);             // of the whole line; or another range of hits: see there
///     bool contains(const G&, const Vec3&);
///
/// and for shapes that can be area lights
///
///     L lamp_surface(const G&);                              // G itself, or something around it
///     double area(const L&);                                 // of all its surfaces; possibly infinite
///     AreaPoint point_by_area(const L&, double u, double v); // uniform over the area, for uniform u and v
///
/// A crossing's t depends on the ray and the shape alone, never on the interval: raising `lower` to the last t leads to
/// the next crossing; `lower` is never negative. A ray tangent to a curved surface hits it; one that runs within a flat
/// face or along a straight line of a curved one does not hit that surface. Directions are not zero.
namespace rt {

/// A crossing of a ray with a surface, at origin + t·direction. `part` identifies one of the shape's surfaces (a
/// cylinder's side or one of its ends), as the shape itself defines.
struct Hit {
  double t = std::numeric_limits<double>::max();
  std::uint32_t part = 0;
};

/// The point of a hit relative to `anchor`. If both are far from the origin this is more accurate than subtracting
/// afterwards.
constexpr Vec3 relative_point(const Ray& ray, const Hit& hit, const Vec3& anchor) {
  return (ray.origin - anchor) + ray.direction * hit.t;
}

/// Stores the first of two crossings, in order, that lies in the interval.
inline bool take_first(const Hit& first, const Hit& second, const Interval& range, Hit& hit) {
  if (range.contains(first.t)) return hit = first, true;
  if (range.contains(second.t)) return hit = second, true;
  return false;
}

/// A point of a surface. It is refined: no farther than `error` from the surface, however far the ray travelled. A ray
/// that starts at `position` + `error`·`normal` (or − `error`·`normal`) is on that side of the surface even after
/// rounding, and does not hit it again at its origin.
struct SurfacePoint {
  Vec3 position;
  Vec3 normal; ///< unit, outward (away from the solid side); geometric, not flipped to the viewer
  double error = 0;
};

/// Whether two points where one ray meets surfaces are in one place as far as rounding can tell: they are no farther
/// apart along the normals than the bounds of their errors together.
bool touch(const SurfacePoint& a, const SurfacePoint& b);

/// A point that was drawn from a surface.
struct AreaPoint {
  Vec3 position;
  Vec3 normal; ///< unit, geometric
};

/// The point in scene space of a shape placed by `to_scene`; `to_local` is the inverse. The error grows so that it is
/// still a bound for rays that are transformed to object space to hit the shape.
SurfacePoint mapped(const SurfacePoint& local, const Affine& to_scene, const Affine& to_local);

/// Where a line enters and leaves a solid: at[0] enters, at[1] leaves, at[2] enters again, …; t ascends. t is infinite
/// where the line never enters or leaves. A line that only touches the solid does not enter it.
///
/// `Most` is how many there can be. A solid without such a bound gives a std::vector<Hit> instead.
template <std::size_t Most>
struct CrossingList {
  std::array<Hit, Most> at{};
  int count = 0; ///< even

  void add(const Hit& enter, const Hit& leave) {
    at[static_cast<std::size_t>(count)] = enter;
    at[static_cast<std::size_t>(count + 1)] = leave;
    count += 2;
  }
  const Hit* begin() const { return at.data(); }
  const Hit* end() const { return at.data() + count; }
};

/// Enough for a quadric or simpler, and for a torus.
using Crossings = CrossingList<4>;

} // namespace rt
