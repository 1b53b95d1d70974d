#include "renderer/shading/lights.hpp"

#include <cmath>
#include <limits>

namespace rt {
namespace {

void place(Light& light, const scene::PointLight& source, const Affine& to_world) {
  light.kind = Light::Kind::point;
  light.at = to_world.point(source.at);
  light.fade = source.fade;
}

void place(Light& light, const scene::SunLight& source, const Affine& to_world) {
  light.kind = Light::Kind::sun;
  light.direction = normalize(to_world.vector(source.direction));
}

void place(Light& light, const scene::SpotLight& source, const Affine& to_world) {
  light.kind = Light::Kind::spot;
  light.at = to_world.point(source.at);
  light.direction = normalize(to_world.point(source.look_at) - light.at);
  light.cos_full = cos_degrees(source.angle / 2);
  light.cos_none = cos_degrees(source.falloff.value_or(source.angle) / 2);
  light.fade = source.fade;
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

double spot_at(const Light& light, double cosine) {
  if (cosine >= light.cos_full) return 1;
  if (cosine <= light.cos_none) return 0;
  const double q = (cosine - light.cos_none) / (light.cos_full - light.cos_none);
  return (3 - 2 * q) * q * q;
}

Light make_light(const scene::Light& described) {
  Light light;
  std::visit(
      [&](const auto& source) {
        light.color = source.color * source.intensity;
        light.shadows = source.shadows;
        place(light, source, to_world(described));
      },
      described.source);
  return light;
}

} // namespace rt
