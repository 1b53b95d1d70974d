#pragma once

#include "renderer/lights/light.hpp"
#include "renderer/math/affine.hpp"

namespace rt::scene {

/// Light from a point, the same in all directions.
struct PointLight : LightCommon {
  static constexpr std::string_view noun = "light";
  static constexpr std::string_view help = "a lamp that shines from a point, equally in all directions";
  Vec3 at{};
  Fade fade;
  std::optional<double> radius; ///< of the sphere that it is in path mode; 0
};

std::span<const Field> fields(const PointLight*);
std::optional<Problem> check(const PointLight&);

} // namespace rt::scene

namespace rt {

struct PointEmitter {
  Vec3 at;
  scene::Fade fade;
  double radius = 0;
};

PointEmitter placed(const scene::PointLight& light, const Affine& to_scene);

inline LightExtent extent(const PointEmitter& light) {
  return {false, light.at, light.radius};
}

inline LightSample sample_light(const PointEmitter& light, const Vec3& p) {
  return sample_from(light.at, light.fade, p);
}

} // namespace rt
