#pragma once

#include "renderer/integrators/contacts.hpp"
#include "renderer/shading/lights.hpp"
#include "renderer/shading/media.hpp"
#include "renderer/shading/whitted_bsdf.hpp"

namespace rt {

enum class RayKind : std::uint8_t { camera, reflected, refracted, total_reflection };

/// What one light gives to one point, term by term.
struct LightRecord {
  std::uint32_t light = 0; ///< index in the scene's lights
  LightSample sample;      ///< before shadows
  double cos_light = 0;    ///< n·l
  Color filter = white;    ///< what surfaces on the way leave of the light
  ReflectedLight reflected;
  double left_out = 0; ///< the most that it could have brought to the camera's ray, where `min_weight` says not to look
                       ///< what is in its way: nothing is reflected then
};

/// Listens to the integrator. This one does nothing and costs nothing; a recorder replaces what it wants to hear.
///
/// Each ray is `begin_ray`, what happens to it, `end_ray`. What happens is `miss`; or `too_deep`; or `surface`, then
/// `own_light`, `light` for each light in turn, and the branches. A branch is its event (`reflection`, `refraction`,
/// `total_reflection`) followed by the whole of the branch's ray. Where refraction bends nothing no new ray begins: the
/// same one goes on, to its next `surface`, `miss` or `too_deep`, weighted by what the surface lets by.
struct NoRecorder {
  /// `weight` is the share of this ray's radiance in that of the first one.
  void begin_ray(RayKind, const Ray&, int /*depth*/, const Color& /*weight*/) {}
  void end_ray(const Color& /*radiance*/) {}
  void miss(const Color& /*background*/) {}
  void too_deep() {}
  /// The medium that the ray is in leaves so much of what is seen at the next event, which is so far away.
  void absorption(const Color& /*left*/, double /*length*/) {}
  /// The branch that was told of last is not followed, having this weight in the camera ray's light. In place of its
  /// radiance stands an estimate.
  void too_weak(double /*weight*/, const Color& /*estimate*/) {}
  /// Before `surface`: all that is in one place, of which light takes a part into account. If that is several, they are
  /// met one after the other, each as a surface of its own.
  void touching(const std::vector<MetSurface>&) {}
  /// Before `surface`: it is one of several that touch, or (outside of any contact) it is none.
  void contact(const Contacts&, const Contacts::Position&) {}
  /// `normal` is the shading normal, turned to the viewer.
  void surface(const RayHit&, const Surface&, const MaterialValues&, const Vec3& /*normal*/) {}
  void own_light(const Color& /*ambient*/, const Color& /*emission*/) {}
  /// What blocks the light, if something does, is found along the rules' ray that leaves the surface.
  void light(const LightRecord&, const Surface&) {}
  /// ρ, and what is in it of Fresnel's reflectance (1 where it is not asked for) at this cosine and ratio of indices.
  void reflection(const Color& /*rho*/, double /*reflectance*/, double /*cosine*/, double /*eta*/) {}
  /// τ, the solid that is entered or left, and the cosines before and behind the surface.
  void refraction(const Color& /*tau*/, const MediumTransition&, double /*cosine*/, double /*cosine_behind*/) {}
  void total_reflection(const MediumTransition&, double /*cosine*/) {}
};

} // namespace rt
