#include "renderer/lights/point.hpp"

namespace rt::scene {

std::span<const Field> fields(const PointLight*) {
  static constexpr Field table[] = {
      field<&PointLight::at>("at", {"[0, 0, 0]", "position"}),
      color_field<PointLight>,
      intensity_field<PointLight>,
      fade_field<PointLight>,
      radius_field<PointLight>,
      shadows_field<PointLight>,
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
