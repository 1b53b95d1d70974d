#include "renderer/lights/sun.hpp"

#include "renderer/math/degrees.hpp"

namespace rt::scene {

std::span<const Field> fields(const SunLight*) {
  static constexpr Constraint seen_angle{.min = 0, .max = 180};
  static constexpr Field table[] = {
      field<&SunLight::direction>("direction", {"[-1, -2, -1]", "direction in which its light travels", nonzero}),
      color_field<SunLight>,
      intensity_field<SunLight>,
      field<&SunLight::size>(
          "size",
          {"0", "in path mode: angular diameter in degrees (0.533 for the real sun); softens shadows", seen_angle}),
      shadows_field<SunLight>,
  };
  return table;
}

std::optional<Problem> check(const SunLight&) {
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

SunEmitter placed(const scene::SunLight& light, const Affine& to_scene) {
  const double half_sine = sin_degrees(light.size.value_or(0) / 4); // of half the half angle: 1 − cos a = 2 sin²(a/2)
  return {normalize(to_scene.vector(light.direction)), 2 * half_sine * half_sine};
}

} // namespace rt
