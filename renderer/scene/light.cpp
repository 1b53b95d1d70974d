#include "renderer/scene/light.hpp"

namespace rt::scene {

Affine to_world(const Light& light) {
  Affine map;
  for (const Step& step : light.chain) map = matrix(step) * map;
  for (const Placement& outer : light.enclosing) map = matrix(outer) * map;
  return map;
}

} // namespace rt::scene
