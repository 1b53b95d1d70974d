#pragma once

#include "renderer/compile/compiled_scene.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Coincident surfaces: two solids that share a face, a solid resting on a floor. Which of them a ray hits first is a
/// matter of rounding, so they are treated together.
namespace rt {

/// A surface that a ray hit.
struct MetSurface {
  RayHit hit;
  Surface surface;
  double error = 0;       ///< a bound on the error of the surface's point
  bool is_opaque = false; ///< transmits no light at this point
};

/// What a ray meets in one place.
struct TouchingSurfaces {
  /// All of them. Those that count come first: the first declared of the opaque ones, which ends the ray; or, if all
  /// are transparent, one for each solid that is entered or left, those whose normal the ray goes against first, then
  /// in the order of declaration. A ray that starts `Surface::offset` off one of them starts beyond them all.
  std::vector<MetSurface> surfaces;
  /// How many count. None: every solid entered there is left at once.
  std::size_t count = 0;

  /// The ray's t at the last of them.
  double end() const;
};

/// Whether surfaces that cast no shadow count.
enum class Touching { all, casting };

/// What the ray hits where `nearest`, its nearest hit in `range`, is contested. Stored in `found`.
void find_touching(const CompiledScene& scene, const Ray& ray, const Interval& range, const RayHit& nearest,
                   TraceScratch& scratch, TouchingSurfaces& found, Touching which = Touching::all);

/// The first surface that counts in `range`.
std::optional<MetSurface> first_surface(const CompiledScene& scene, const Ray& ray, const Interval& range,
                                        TraceScratch& scratch);

/// Puts solids that begin where `ray` meets their touching surfaces in order from the inside out: one that lies within
/// another reaches less far from there, and in no direction farther. Where that does not tell, the higher index of
/// refraction is inside, then the one declared last.
void sort_inside_out(const CompiledScene& scene, const Ray& ray, std::span<MetSurface> entered);

} // namespace rt
