#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/scene/transform.hpp"

namespace rt::scene {

/// What all lights share.
struct LightCommon {
  Color color = white;
  double intensity = 1;
  bool shadows = true; ///< false: nothing blocks it, and it gives diffuse light only
};

/// Light from a point, equal in all directions.
struct PointLight : LightCommon {
  Vec3 at{};
  Fade fade;
};

/// Light from infinitely far away, travelling along `direction`; never fades.
struct SunLight : LightCommon {
  Vec3 direction{-1, -2, -1};
};

/// A point light within a cone about the line to `look_at`: full inside the full angle `angle`, none outside
/// `falloff` (degrees, `angle` unless given), a smoothstep in the cosine of the half angle between.
struct SpotLight : LightCommon {
  Vec3 at{0, 3, 0}; ///< from there a sphere of radius 1 about the origin just fits the cone: asin(1/3) = 19.5°
  Vec3 look_at{};
  double angle = 40;
  std::optional<double> falloff;
  Fade fade;
};

using LightSource = std::variant<PointLight, SunLight, SpotLight>;

std::span<const Field> fields(const PointLight*);
std::span<const Field> fields(const SunLight*);
std::span<const Field> fields(const SpotLight*);
std::optional<Problem> check(const PointLight&);
std::optional<Problem> check(const SunLight&);
std::optional<Problem> check(const SpotLight&);

} // namespace rt::scene
