#include "renderer/lights/point.hpp"

namespace rt::scene {

std::span<const Field> fields(const PointLight*) {
  static constexpr Field table[] = {
      field<&PointLight::at>("at", {"[0, 0, 0]", "position"}),
      field<&PointLight::color>("color", {"white", "colour of the light", not_negative}),
      field<&PointLight::intensity>("intensity", {"1", "factor on the colour", not_negative}),
      field<&PointLight::fade>("fade",
                               {"none", "linear(d), quadratic(d) or inverse_square: how it weakens with distance"}),
      field<&PointLight::radius>(
          "radius", {"0", "in path: of the ball that it is; softens shadows, as bright as ever", not_negative}),
      field<&PointLight::shadows>("shadows", {"true", "false: nothing blocks it and it makes no highlight"}),
  };
  return table;
}

std::optional<Problem> check(const PointLight&) {
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

PointEmitter placed(const scene::PointLight& light, const Affine& to_scene) {
  return {to_scene.point(light.at), light.fade, light.radius.value_or(0) * mean_scale(to_scene)};
}

} // namespace rt
