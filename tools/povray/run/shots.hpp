#pragma once

#include "tools/povray/run/povray.hpp"

namespace rt::tools::povray {

/// POV-Ray's view of a scene: its picture, and what each pixel's centre ray hits first.
struct Shots {
  int width = 0, height = 0;
  std::vector<Rgb32> color; ///< linear, the mean over a pixel's samples
  std::vector<std::uint32_t> ids;
  std::vector<double> depth; ///< infinite for a miss
  std::vector<Xyz32> normal; ///< unit, facing the viewer; zero for a miss
  bool is_float = true;      ///< false: colours were clamped to [0, 1] and rounded to 16 bits
};

struct ShootOptions {
  RunOptions run;
  int at_once = 4; ///< how many instances of POV-Ray run concurrently
};

/// Exports and renders all passes. Throws Missing or Failed.
Shots shoot(const scene::Scene& scene, const ShootOptions& options = {});

/// What a pixel's id refers to.
struct ObjectName {
  std::string name; ///< the nearest name written for it or a group around it, else what it is ("sphere")
  scene::Origin origin;
};
/// All objects that have ids: that of `id` is at `id − 1`.
std::vector<ObjectName> object_names(const scene::Scene& scene);

} // namespace rt::tools::povray
