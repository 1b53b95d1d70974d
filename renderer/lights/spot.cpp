#include "renderer/lights/spot.hpp"

#include "renderer/math/degrees.hpp"

namespace rt::scene {

std::span<const Field> fields(const SpotLight*) {
  static constexpr Constraint cone{.min = 0, .max = 180, .min_is_excluded = true, .max_is_excluded = true};
  static constexpr Field table[] = {
      field<&SpotLight::at>("at", {"[0, 3, 0]", "position"}),
      field<&SpotLight::look_at>("look_at", {"[0, 0, 0]", "point on the axis of the cone"}),
      field<&SpotLight::angle>("angle", {"40", "full angle of the cone of full intensity, degrees", cone}),
      field<&SpotLight::falloff>("falloff",
                                 {"angle", "full angle of the cone outside which there is no light, degrees", cone}),
      color_field<SpotLight>,
      intensity_field<SpotLight>,
      fade_field<SpotLight>,
      radius_field<SpotLight>,
      shadows_field<SpotLight>,
  };
  return table;
}

std::optional<Problem> check(const SpotLight& light) {
  if (light.at == light.look_at)
    return Problem{"look_at", "a spot needs a direction: `look_at` equals its position `at`"};
  if (light.falloff && *light.falloff < light.angle)
    return Problem{"falloff", "`falloff` is the outer cone: it must not be smaller than `angle`"};
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

SpotEmitter placed(const scene::SpotLight& light, const Affine& to_scene) {
  const Vec3 at = to_scene.point(light.at);
  return {at,
          normalize(to_scene.point(light.look_at) - at),
          cos_degrees(light.angle / 2),
          cos_degrees(light.falloff.value_or(light.angle) / 2),
          light.fade,
          light.radius.value_or(0) * mean_scale(to_scene)};
}

double spot_at(const SpotEmitter& light, double cosine) {
  if (cosine >= light.cos_full) return 1;
  if (cosine <= light.cos_none) return 0;
  const double q = (cosine - light.cos_none) / (light.cos_full - light.cos_none);
  return (3 - 2 * q) * q * q;
}

} // namespace rt
