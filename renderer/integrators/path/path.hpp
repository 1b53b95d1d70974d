#pragma once

#include "renderer/integrators/integrator.hpp"

namespace rt {

/// Solves the rendering equation (J. Kajiya, The Rendering Equation, 1986) by paths from the camera, each of which is
/// one estimate of the light that comes in along a ray. `max_depth` counts the surfaces after the first that scatter.
/// Light is basic radiance, L/n²: what is refracted keeps its value.
std::unique_ptr<const Integrator> make_path(const CompiledScene& scene);

} // namespace rt
