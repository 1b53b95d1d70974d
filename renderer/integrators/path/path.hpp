#pragma once

#include "renderer/integrators/integrator.hpp"

namespace rt {

/// Solves the rendering equation (J. Kajiya, The Rendering Equation, 1986) by paths from the camera, each an estimate
/// of the radiance along a ray. `max_depth` counts the scattering surfaces after the first. Light is basic radiance,
/// L/n², which refraction leaves unchanged.
std::unique_ptr<const Integrator> make_path(const CompiledScene& scene);

} // namespace rt
