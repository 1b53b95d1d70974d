#include "renderer/lights/sky.hpp"

namespace rt::scene {

std::span<const Field> fields(const SkyLight*) {
  static constexpr Field table[] = {
      field<&SkyLight::zenith>("zenith", {"white", "colour straight above", not_negative}),
      field<&SkyLight::horizon>("horizon", {"white", "colour at the horizon", not_negative}),
      field<&SkyLight::ground>("ground", {"0.3 * horizon", "colour below the horizon", not_negative}),
      field<&SkyLight::intensity>("intensity", {"1", "factor on the colours", not_negative}),
  };
  return table;
}

std::optional<Problem> check(const SkyLight&) {
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

SkyEmitter placed(const scene::SkyLight& light, const Affine& to_scene) {
  const Color ground = light.ground.value_or(light.horizon * 0.3);
  return {light.zenith * light.intensity, light.horizon * light.intensity, ground * light.intensity,
          normalize(to_scene.vector({0, 1, 0}))};
}

} // namespace rt
