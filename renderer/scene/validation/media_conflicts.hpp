#pragma once

#include "renderer/scene/scene.hpp"

#include <span>
#include <vector>

namespace rt::scene {

/// A combination whose parts refract, or reflect by Fresnel's equations, as if they were different media. A solid is a
/// single medium: its own material's, else its parts'.
struct MediaConflict {
  std::uint32_t combination; ///< its index among the scene's combinations
  double first_ior, second_ior;
};

/// Those among `objects` and in their groups, given the materials that they inherit there. The scene's references must
/// be valid.
std::vector<MediaConflict> media_conflicts(const Scene& scene, std::span<const Object> objects);

} // namespace rt::scene
