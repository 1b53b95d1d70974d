#pragma once

#include "tools/explain/why/contributions.hpp"

#include <optional>
#include <vector>

namespace rt::tools::explain {

/// What a surface would show most of if its surroundings were equally bright.
enum class Prospect : std::uint8_t { own_shading, mirrored, through, totally_reflected };
Prospect prospect(const SurfaceNode& surface);

/// One surface on the path of light to the eye, or the path's end without a surface.
struct PathStep {
  const RayNode* ray;         ///< that hit it
  const SurfaceNode* surface; ///< null: the ray ends in the background, at max_depth, or is not expanded
  /// How the path continues from the surface; nothing at its end, whose own shading is the light's source.
  std::optional<WayStep::How> onwards;
};
struct LightPath {
  std::vector<PathStep> steps; ///< from the first ray on; never empty
  Color light;                 ///< that it carries to the eye
};

/// The path that carries most of the light: all terms that came from one surface (or the background) the same way count
/// together. If there is no light at all, the path along which each surface would show most (`prospect`).
LightPath main_path(const RayNode& root, const Sum& sum);

} // namespace rt::tools::explain
