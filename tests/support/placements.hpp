#pragma once

#include "renderer/math/random.hpp"
#include "tests/support/scenes.hpp"

#include <utility>
#include <vector>

/// Scenes that stand anywhere, turned and scaled.
namespace rt::tests {

/// A placement of everything there is: turned in any way, scaled, and moved by up to `reach` of its size.
inline scene::Placement anywhere(SplitMix64& random, double scale, double reach = 3) {
  const auto angle = [&] { return random.between(-180, 180); };
  const auto move = [&] { return random.between(-reach, reach) * scale; };
  return {{scale, scale, scale}, {angle(), angle(), angle()}, {move(), move(), move()}, {}};
}

/// The ray in the scene, with a unit direction.
inline Ray carried(const scene::Placement& placement, const Vec3& origin, const Vec3& direction) {
  const Affine map = matrix(placement);
  return {map.point(origin), normalize(map.vector(direction))};
}

/// All of the scene as one group that stands there.
inline void place(SceneBuilder& k, std::vector<scene::Object> things, const scene::Placement& placement) {
  scene::Placement turned = placement;
  scene::Object whole = k.group(std::move(things));
  whole.at = turned.at, turned.at = {};
  whole.transform = k.transform(turned);
  k.add(whole);
}

} // namespace rt::tests
