#pragma once

#include "renderer/compile/compiled_scene.hpp"

#include <algorithm>
#include <limits>
#include <span>

/// What integrators leave open about rays at surfaces: our own rules, and POV-Ray's.
namespace rt {

/// Ours: a ray may hit something at any distance, because its origin is offset from the surface by its rounding error
/// bound.
struct OwnRules {
  /// The ray that leaves a surface: offset by the point's error bound, on the side it goes to.
  static Ray leave(const Surface& surface, const Vec3& direction) {
    const double side = dot(surface.normal, direction) < 0 ? -surface.error : surface.error;
    return {surface.position + surface.normal * side, direction};
  }

  /// The range in which hits of a camera, reflected or refracted ray count.
  static constexpr Interval hit_range() { return {0, std::numeric_limits<double>::max()}; }
  /// And of a shadow ray to a light at this distance. It ends just before the light, so that a light lying in a surface
  /// is not blocked by it.
  static Interval shadow_range(double distance) {
    return {0, std::min(distance * (1 - 0x1p-40), std::numeric_limits<double>::max())};
  }

  /// How a shadow ray's transmittance is computed: all surfaces in its range attenuate it, in any order. Several rays
  /// must be coherent.
  static void transmit(const CompiledScene& scene, std::span<const ShadowRay> rays, std::span<TraceScratch> scratch) {
    if (rays.size() == 1)
      *rays[0].transmittance = scene.transmittance(rays[0].ray, rays[0].range, scratch[0]);
    else
      scene.transmittance(rays, scratch);
  }

  /// The shading normal facing the viewer of a ray with this direction: flipped as the surface itself is, so that an
  /// interpolated normal is lit from one side all over the surface, even where it faces away beyond a silhouette. (A
  /// triangle's winding may be opposite to its normals.)
  static Vec3 turned_normal(const Surface& surface, const Vec3& direction) {
    const Vec3 &face = surface.normal, &shading = surface.shading_normal;
    return dot(face, direction) * dot(face, shading) > 0 ? -shading : shading;
  }

  /// The total weight of weak rays that need not be traced.
  static double min_weight(const CompiledScene& scene) { return scene.min_weight(); }

  /// Touching surfaces are one event.
  static constexpr bool joins_touching = true;

  /// How the ratio of two indices is rounded: not at all.
  static double eta(double ratio, bool /*touches_void*/) { return ratio; }
};

/// Ours, restricted to what an export can express: for comparing pictures with POV-Ray's. Every ray is traced, and
/// interpolated normals are flipped as POV-Ray does.
struct ExportedRules : OwnRules {
  static Vec3 turned_normal(const Surface& surface, const Vec3& direction) {
    return dot(surface.shading_normal, direction) > 0 ? -surface.shading_normal : surface.shading_normal;
  }
  static double min_weight(const CompiledScene&) { return 0; }
};

/// POV-Ray's, for explaining where its pictures differ from ours. Its distances are in scene units.
struct PovrayRules {
  /// Rays start on the surface, and hits that are too near do not count.
  static Ray leave(const Surface& surface, const Vec3& direction) { return {surface.position, direction}; }

  static constexpr Interval hit_range() { return {1e-4, 1e7}; }
  static Interval shadow_range(double distance) {
    return {1e-3, std::min(distance - 1e-3, std::numeric_limits<double>::max())};
  }

  /// From surface to surface, each starting a new ray.
  static void transmit(const CompiledScene& scene, std::span<const ShadowRay> rays, std::span<TraceScratch>) {
    for (const ShadowRay& ray : rays)
      *ray.transmittance = scene.transmittance_by_steps(ray.ray, ray.range.upper, ray.range.lower);
  }

  static Vec3 turned_normal(const Surface& surface, const Vec3& direction) {
    return ExportedRules::turned_normal(surface, direction);
  }
  static double min_weight(const CompiledScene&) { return 0; }

  /// Rounding decides which of several touching surfaces a ray hits, and it misses those that it starts on.
  static constexpr bool joins_touching = false;

  /// Between two solids in 32 bits, between a solid and the void in 64.
  static double eta(double ratio, bool touches_void) { return touches_void ? ratio : static_cast<float>(ratio); }
};

} // namespace rt
