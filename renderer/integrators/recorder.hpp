#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/shading/lights.hpp"
#include "renderer/shading/media.hpp"
#include "renderer/shading/whitted_bsdf.hpp"

namespace rt {

enum class RayKind : std::uint8_t { camera, reflected, refracted, total_reflection };

/// What one light contributes at one point, term by term.
struct LightRecord {
  std::uint32_t light = 0; ///< index in the scene's lights
  LightSample sample;      ///< before shadows
  double cos_light = 0;    ///< n·l
  Color filter = white;    ///< the transmittance of the surfaces on the way
  ReflectedLight reflected;
  double left_out = 0; ///< the most that it could have contributed to the camera ray, where `min_weight` makes a shadow
                       ///< ray unnecessary: nothing is reflected then
};

/// Observes the integrator. This one does nothing and costs nothing; a recorder overrides the events it needs.
///
/// Each ray is `begin_ray`, its events, `end_ray`. The events are `miss`; or `too_deep`; or `surface`, then
/// `own_light`, `light` for each light in turn, and the branches. A branch is its event (`reflection`, `refraction`,
/// `total_reflection`) followed by all events of the branch's ray. Where refraction does not bend the ray no new one
/// begins: it continues to its next `surface`, `miss` or `too_deep`, weighted by the surface's transmittance.
struct NoRecorder {
  /// `weight` is the factor of this ray's radiance in that of the first one.
  void begin_ray(RayKind, const Ray&, int /*depth*/, const Color& /*weight*/) {}
  void end_ray(const Color& /*radiance*/) {}
  void miss(const Color& /*background*/) {}
  void too_deep() {}
  /// The transmittance of the ray's medium up to the next event, and the distance to that.
  void absorption(const Color& /*left*/, double /*length*/) {}
  /// The branch that was told of last is not followed, having this weight in the camera ray's light. In place of its
  /// radiance stands an estimate.
  void too_weak(double /*weight*/, const Color& /*estimate*/) {}
  /// Before `surface`: all that is in one place, of which light takes a part into account. If that is several, they are
  /// met one after the other, each as a surface of its own.
  void touching(const std::vector<MetSurface>&) {}
  /// Before `surface`: it is one of several that touch, or (outside of any contact) it is not.
  void contact(const Contacts&, const Contacts::Position&) {}
  /// `normal` is the shading normal, facing the viewer.
  void surface(const RayHit&, const Surface&, const MaterialValues&, const Vec3& /*normal*/) {}
  void own_light(const Color& /*ambient*/, const Color& /*emission*/) {}
  /// The occluder, if there is one, is found along the shadow ray that the rules start at the surface.
  void light(const LightRecord&, const Surface&) {}
  /// ρ, the Fresnel reflectance in it (1 if not used), the cosine and the ratio of indices it was computed for.
  void reflection(const Color& /*rho*/, double /*reflectance*/, double /*cosine*/, double /*eta*/) {}
  /// τ, the solid that is entered or left, and the cosines before and behind the surface.
  void refraction(const Color& /*tau*/, const MediumTransition&, double /*cosine*/, double /*cosine_behind*/) {}
  void total_reflection(const MediumTransition&, double /*cosine*/) {}
};

} // namespace rt
