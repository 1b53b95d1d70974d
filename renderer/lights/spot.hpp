#pragma once

#include "renderer/lights/light.hpp"
#include "renderer/math/affine.hpp"

namespace rt::scene {

/// A point light within a cone about the line to `look_at`: full inside the full angle `angle`, none outside `falloff`
/// (degrees, `angle` unless given), with a smoothstep in the cosine of the half angle between them.
struct SpotLight : LightCommon {
  static constexpr std::string_view noun = "spot";
  static constexpr std::string_view help = "a lamp that shines within a cone";
  Vec3 at{0, 3, 0}; ///< from there a sphere of radius 1 about the origin just fits into the cone: asin(1/3) = 19.5°
  Vec3 look_at{};
  double angle = 40;
  std::optional<double> falloff;
  Fade fade;
  std::optional<double> radius; ///< of the sphere that it is in path mode; 0
};

std::span<const Field> fields(const SpotLight*);
std::optional<Problem> check(const SpotLight&);

} // namespace rt::scene

namespace rt {

struct SpotEmitter {
  Vec3 at;
  Vec3 axis;       ///< unit, away from the light
  double cos_full; ///< of the half angle of the cone of full light
  double cos_none; ///< of the half angle beyond which there is none
  scene::Fade fade;
  double radius = 0;
};

SpotEmitter placed(const scene::SpotLight& light, const Affine& to_scene);

inline LightExtent extent(const SpotEmitter& light) {
  return {false, light.at, light.radius};
}

/// How much of its light leaves it at this angle off its axis: a smoothstep in the cosine.
double spot_at(const SpotEmitter& light, double cosine);

inline LightSample sample_light(const SpotEmitter& light, const Vec3& p) {
  LightSample sample = sample_from(light.at, light.fade, p);
  sample.spot = spot_at(light, -dot(sample.to_light, light.axis));
  return sample;
}

} // namespace rt
