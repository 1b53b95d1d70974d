#include "renderer/lights/sun.hpp"

namespace rt::scene {

std::span<const Field> fields(const SunLight*) {
  static constexpr Field table[] = {
      field<&SunLight::direction>("direction", {"[-1, -2, -1]", "the way its light travels", nonzero}),
      field<&SunLight::color>("color", {"white", "colour of the light", not_negative}),
      field<&SunLight::intensity>("intensity", {"1", "factor on the colour", not_negative}),
      field<&SunLight::shadows>("shadows", {"true", "false: nothing blocks it and it makes no highlight"}),
  };
  return table;
}

std::optional<Problem> check(const SunLight&) {
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

SunEmitter placed(const scene::SunLight& light, const Affine& to_scene) {
  return {normalize(to_scene.vector(light.direction))};
}

} // namespace rt
