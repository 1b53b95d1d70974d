#pragma once

#include "renderer/integrators/interiors.hpp"
#include "renderer/lights.hpp"
#include "renderer/materials.hpp"
#include "renderer/traceable.hpp"

namespace rt {

enum class RayKind : std::uint8_t { camera, reflected, refracted, straight_on, total_reflection };

/// What one lamp gives to one point, term by term.
struct LightRecord {
  std::uint32_t lamp = 0;   ///< index in the scene's lights
  Incidence incidence;      ///< before shadows
  double cos_light = 0;     ///< n·l
  double cos_highlight = 0; ///< n·h, or r·l for Phong's form
  Color filter = white;     ///< what surfaces on the way leave of the light
  Color tint = white;       ///< of a metal's highlight
  Color diffuse, highlight; ///< the terms themselves
};

/// Listens to the integrator. This one does nothing, and costs nothing; a recorder replaces all of these. For each ray
/// come `begin_ray`; then `miss`, `too_deep`, or `surface`, `own_light`, `light` for each lamp, and for each branch its
/// event followed by the whole of the branch's ray; then `end_ray`.
struct NoRecorder {
  static constexpr bool is_recording = false;

  void begin_ray(RayKind, const Ray&, int /*depth*/, const Color& /*weight*/) {}
  void end_ray(const Color& /*radiance*/) {}
  void miss(const Color& /*background*/) {}
  void too_deep() {}
  void surface(const RayHit&, const Surface&, const MaterialValues&, const Vec3& /*normal to the viewer*/) {}
  void own_light(const Color& /*ambient*/, const Color& /*emission*/) {}
  void light(const LightRecord&, const Surface&) {}
  void reflection(const Color& /*weight*/, double /*fresnel, or 1*/, double /*cos*/, double /*eta*/) {}
  void refraction(const Color& /*weight*/, const Passage&, double /*cos in*/, double /*cos out*/) {}
};

} // namespace rt
