#pragma once

#include "renderer/integrators/whitted.hpp"

#include <vector>

namespace rt::tools::bench {

/// All rays of a frame in the order in which the integrator traces them, so that they can be traced again in
/// isolation.
struct FrameRays {
  std::vector<Ray> nearest; ///< unit directions
  std::vector<Ray> shadow;
  std::vector<double> shadow_ends; ///< the distance of the light
};

/// For the whole picture, a square of `size` pixels.
FrameRays frame_rays(const CompiledScene& scene, const scene::Camera& camera, int size);

} // namespace rt::tools::bench
