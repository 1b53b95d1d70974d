#pragma once

#include "renderer/lights/light.hpp"
#include "renderer/math/affine.hpp"

#include <limits>

namespace rt::scene {

/// Light from infinitely far away, travelling along `direction`; never fades.
struct SunLight : LightCommon {
  static constexpr std::string_view noun = "sun";
  static constexpr std::string_view help = "light from infinitely far away; it never fades";
  Vec3 direction{-1, -2, -1};
  std::optional<double> size; ///< its angular diameter in path mode, degrees; 0
};

std::span<const Field> fields(const SunLight*);
std::optional<Problem> check(const SunLight&);

} // namespace rt::scene

namespace rt {

struct SunEmitter {
  Vec3 direction;        ///< unit; the direction in which its light travels
  double cap_height = 0; ///< 1 − cos of half its angular diameter
};

SunEmitter placed(const scene::SunLight& light, const Affine& to_scene);

inline LightExtent extent(const SunEmitter& light) {
  return {true, -light.direction, light.cap_height};
}

inline LightSample sample_light(const SunEmitter& light, const Vec3&) {
  return {-light.direction, std::numeric_limits<double>::infinity()};
}

} // namespace rt
