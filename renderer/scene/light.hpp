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

/// A light, its own chain, and the placements of the composites it stands in, from the inside out. Its position and
/// direction in the scene are its fields carried through `chain` and then each of `enclosing`.
struct Light {
  LightSource source;
  std::vector<Step> chain;
  std::vector<Placement> enclosing;
  NameId name = no_name;
  Origin origin;
};

/// The light's map from where its fields hold to the scene.
Affine to_world(const Light& light);

/// Whether it shines on what it faces in any mode. A sky lights the scene in path mode alone.
inline bool is_lamp(const Light& light) {
  return !std::holds_alternative<SkyLight>(light.source);
}

} // namespace rt::scene
