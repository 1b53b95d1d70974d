#pragma once

#include "renderer/integrators/integrator.hpp"

namespace rt {

/// Ambient occlusion: how much of the sky a surface sees, as a grey. Each sample is one direction above the first
/// surface, drawn with density cos θ / π: white if nothing that casts a shadow is within the scene's `reach`. A ray
/// that hits nothing is white too. Materials do not matter.
std::unique_ptr<const Integrator> make_occlusion(const CompiledScene& scene);

} // namespace rt
