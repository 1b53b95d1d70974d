#pragma once

#include "renderer/math/color.hpp"
#include "renderer/scene/scene.hpp"

#include <limits>
#include <vector>

namespace rt {

/// A light of the description carried to the scene's space, ready for shading.
struct Light {
  enum class Kind : std::uint8_t { point, sun, spot };
  Kind kind = Kind::point;
  bool shadows = true; ///< false: nothing blocks it, and it gives diffuse light only
  Color color;         ///< colour times intensity
  Vec3 at;             ///< of a point or spot
  Vec3 direction;      ///< unit; the way a sun's light travels, or the axis of a spot
  double cos_full = 1; ///< of the half angle of a spot's cone of full light
  double cos_none = 1; ///< of the half angle beyond which there is none
  scene::Fade fade;
};

/// A light as one point of the scene sees it.
struct LightSample {
  Vec3 to_light;   ///< unit
  double distance; ///< to the light; infinite for a sun
  double fade;     ///< the weakening with distance
  double spot;     ///< 0 outside a spot's cone, 1 in its full light and for all other lights
  Color color;     ///< of the light that arrives if nothing is in the way: color · fade · spot
};

Light make_light(const scene::Light& light);

/// What is left of light at a distance.
double fade_at(const scene::Fade& fade, double distance);
/// How much of a spot's light leaves it at this angle off its axis: a smoothstep in the cosine.
double spot_at(const Light& light, double cosine);

/// At `p`, which must not be where a point light or spot stands (then `distance` is 0 and the rest meaningless).
inline LightSample sample_light(const Light& light, const Vec3& p) {
  if (light.kind == Light::Kind::sun)
    return {-light.direction, std::numeric_limits<double>::infinity(), 1, 1, light.color};
  const Vec3 way = light.at - p;
  const double distance = length(way);
  const Vec3 to_light = way / distance;
  const double fade = light.fade.law == scene::Fade::Law::none ? 1 : fade_at(light.fade, distance);
  const double spot = light.kind == Light::Kind::spot ? spot_at(light, -dot(to_light, light.direction)) : 1;
  return {to_light, distance, fade, spot, light.color * (fade * spot)};
}

} // namespace rt
