#pragma once

#include "renderer/fields/type_list.hpp"
#include "renderer/lights/point.hpp"
#include "renderer/lights/sky.hpp"
#include "renderer/lights/spot.hpp"
#include "renderer/lights/sun.hpp"
#include "renderer/scene/object.hpp"
#include "renderer/scene/transform.hpp"

namespace rt::scene {

/// All lights. A new light is added here, and its header above.
using LightKinds = TypeList<PointLight, SunLight, SpotLight, SkyLight>;
using LightSource = LightKinds::Variant;

/// A light, its chain, and the placements of the composites that contain it, from the inside out. Its position and
/// direction in the scene are its fields transformed by `chain` and then each of `enclosing`.
struct Light {
  LightSource source;
  std::vector<Step> chain;
  std::vector<Placement> enclosing;
  NameId name = no_name;
  Origin origin;
};

/// The map from the space of the light's fields to the scene.
Affine to_world(const Light& light);

/// Whether it illuminates surfaces in every mode. A sky does so only in path mode.
inline bool is_lamp(const Light& light) {
  return !std::holds_alternative<SkyLight>(light.source);
}

} // namespace rt::scene
