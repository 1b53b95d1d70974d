#pragma once

#include "renderer/lights/light.hpp"
#include "renderer/math/affine.hpp"

#include <limits>

namespace rt::scene {

/// Light from all around, from infinitely far away: what rays that hit nothing see. It blends from the horizon to the
/// zenith with the sine of the elevation; below the horizon it is constant. Only path mode lights surfaces with it.
struct SkyLight : LightCommon { // with its own colours instead of the common one
  static constexpr std::string_view noun = "sky";
  static constexpr std::string_view help = "what rays that hit nothing see; in path mode it lights the scene";
  Color zenith = white, horizon = white;
  std::optional<Color> ground; ///< 0.3 of the horizon
};

std::span<const Field> fields(const SkyLight*);
std::optional<Problem> check(const SkyLight&);

} // namespace rt::scene

namespace rt {

struct SkyEmitter {
  Color zenith, horizon, ground;
  Vec3 up; ///< unit
};

SkyEmitter placed(const scene::SkyLight& light, const Affine& to_scene);

/// The radiance from `direction` (unit).
inline Color radiance(const SkyEmitter& sky, const Vec3& direction) {
  const double height = dot(sky.up, direction);
  return height < 0 ? sky.ground : sky.horizon + (sky.zenith - sky.horizon) * height;
}

/// It is no lamp, and has no size as one.
inline LightExtent extent(const SkyEmitter& sky) {
  return {true, sky.up};
}

/// It gives nothing as a lamp: nobody knows from where its light comes.
inline LightSample sample_light(const SkyEmitter& sky, const Vec3&) {
  return {sky.up, std::numeric_limits<double>::infinity(), 0};
}

} // namespace rt
