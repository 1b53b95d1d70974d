#pragma once

#include "tools/explain/why/contributions.hpp"

#include <optional>
#include <vector>

namespace rt::tools::explain {

/// What a surface would show most of if all around it were equally bright.
enum class Prospect : std::uint8_t { own_shading, mirrored, through, totally_reflected };
Prospect prospect(const SurfaceNode& surface);

/// One surface on the path that light took to the eye, or its end without one.
struct PathStep {
  const RayNode* ray;         ///< that met it
  const SurfaceNode* surface; ///< null: the ray ends in the background, at max_depth, or is not expanded
  /// Where the path goes on from the surface; nothing at its end, whose own shading is the light's source.
  std::optional<WayStep::How> onwards;
};
struct LightPath {
  std::vector<PathStep> steps; ///< from the first ray on; never empty
  Color light;                 ///< that it brings to the eye
};

/// The path that carries most of the light: all terms that came to one surface (or to the background) the same way
/// count together. Where there is no light at all, the path along which each surface would show most (`prospect`).
LightPath main_path(const RayNode& root, const Sum& sum);

} // namespace rt::tools::explain
