#pragma once

#include "renderer/compile/compiled_scene.hpp"

#include <algorithm>
#include <limits>
#include <span>

/// What an integrator leaves open about rays at surfaces: our own rules, and POV-Ray's.
namespace rt {

/// Ours: a ray may find something anywhere, because its origin is moved off the surface by the bound of its own
/// rounding.
struct OwnRules {
  /// Where a ray leaves a surface: beyond the rounding of the point, on the side it goes to.
  static Ray leave(const Surface& surface, const Vec3& direction) {
    const double side = dot(surface.normal, direction) < 0 ? -surface.error : surface.error;
    return {surface.position + surface.normal * side, direction};
  }

  /// The range in which hits of a camera, mirrored or refracted ray count.
  static constexpr Interval hit_range() { return {0, std::numeric_limits<double>::max()}; }
  /// And of a ray to a light at this distance. It ends a rounding before the light, so that a light lying in a surface
  /// shines.
  static Interval shadow_range(double distance) {
    return {0, std::min(distance * (1 - 0x1p-40), std::numeric_limits<double>::max())};
  }

  /// How a shadow ray's transmittance is followed: all that is in its range filters it, in any order. Several rays must
  /// run close together.
  static void transmit(const CompiledScene& scene, std::span<const ShadowRay> rays, std::span<TraceScratch> scratch) {
    if (rays.size() == 1)
      *rays[0].transmittance = scene.transmittance(rays[0].ray, rays[0].range, scratch[0]);
    else
      scene.transmittance(rays, scratch);
  }

  /// The shading normal turned to the viewer of a ray that comes in this direction: as the surface itself is turned, so
  /// that an interpolated normal is lit from one side all over the surface, even where it faces away beyond a rim. (The
  /// order of a triangle's corners may be the other one than its normals suggest.)
  static Vec3 turned_normal(const Surface& surface, const Vec3& direction) {
    const Vec3 &face = surface.normal, &shading = surface.shading_normal;
    return dot(face, direction) * dot(face, shading) > 0 ? -shading : shading;
  }

  /// What weak rays that are not followed may weigh together.
  static double min_weight(const CompiledScene& scene) { return scene.min_weight(); }

  /// Surfaces that touch are one event.
  static constexpr bool joins_touching = true;

  /// How the ratio of two indices is rounded: not at all.
  static double eta(double ratio, bool /*touches_void*/) { return ratio; }
};

/// Ours in what an export can say: for comparing pictures with POV-Ray's. Every ray is followed, and interpolated
/// normals are turned as POV-Ray does.
struct ExportedRules : OwnRules {
  static Vec3 turned_normal(const Surface& surface, const Vec3& direction) {
    return dot(surface.shading_normal, direction) > 0 ? -surface.shading_normal : surface.shading_normal;
  }
  static double min_weight(const CompiledScene&) { return 0; }
};

/// POV-Ray's, for explaining where its pictures differ from ours. Its distances are in lengths of the scene.
struct PovrayRules {
  /// Rays start on the surface, and what is too near is not hit.
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

  /// Of surfaces that touch, rounding decides which a ray meets, and it misses those that it starts on.
  static constexpr bool joins_touching = false;

  /// Between two solids in 32 bits, between a solid and the void in 64.
  static double eta(double ratio, bool touches_void) { return touches_void ? ratio : static_cast<float>(ratio); }
};

} // namespace rt
