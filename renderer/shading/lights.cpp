#include "renderer/shading/lights.hpp"

#include <cmath>
#include <limits>

namespace rt {
namespace {

void place(Lamp& lamp, const scene::PointLight& light, const Affine& to_world) {
  lamp.kind = Lamp::Kind::point;
  lamp.at = to_world.point(light.at);
  lamp.fade = light.fade;
}

void place(Lamp& lamp, const scene::SunLight& light, const Affine& to_world) {
  lamp.kind = Lamp::Kind::sun;
  lamp.direction = normalize(to_world.vector(light.direction));
}

void place(Lamp& lamp, const scene::SpotLight& light, const Affine& to_world) {
  lamp.kind = Lamp::Kind::spot;
  lamp.at = to_world.point(light.at);
  lamp.direction = normalize(to_world.point(light.look_at) - lamp.at);
  lamp.cos_full = cos_degrees(light.angle / 2);
  lamp.cos_none = cos_degrees(light.falloff.value_or(light.angle) / 2);
  lamp.fade = light.fade;
}

} // namespace

double fade_at(const scene::Fade& fade, double distance) {
  const double relative = distance / fade.distance;
  switch (fade.law) {
  case scene::Fade::Law::none:
    return 1;
  case scene::Fade::Law::linear:
    return 1 / (1 + relative);
  case scene::Fade::Law::quadratic:
    return 1 / (1 + relative * relative);
  case scene::Fade::Law::inverse_square:
    return 1 / (distance * distance);
  }
  return 1;
}

double spot_at(const Lamp& lamp, double cosine) {
  if (cosine >= lamp.cos_full) return 1;
  if (cosine <= lamp.cos_none) return 0;
  const double q = (cosine - lamp.cos_none) / (lamp.cos_full - lamp.cos_none);
  return (3 - 2 * q) * q * q;
}

Lamp make_lamp(const scene::Light& light) {
  Lamp lamp;
  std::visit(
      [&](const auto& source) {
        lamp.color = source.color * source.intensity;
        lamp.shadows = source.shadows;
        place(lamp, source, to_world(light));
      },
      light.source);
  return lamp;
}

} // namespace rt
