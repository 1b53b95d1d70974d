#include "renderer/shading/lights.hpp"

namespace rt {

Light make_light(const scene::Light& light) {
  const Affine to_scene = to_world(light);
  return std::visit(
      [&](const auto& source) {
        return Light{placed(source, to_scene), source.color * source.intensity, source.shadows};
      },
      light.source);
}

std::optional<Vec3> position(const Light& light) {
  const LightExtent where = extent(light);
  return where.is_infinitely_far ? std::nullopt : std::optional(where.place);
}

} // namespace rt
