#pragma once

#include "renderer/scene/camera.hpp"

#include <string>

/// A camera that is moved by hand. What it looks at stays in the centre of the picture, unless it is panned.
namespace rt::tools::preview {

/// Orbits the eye about `look_at`, in degrees: to its right, and upwards to within a degree of straight above or below.
scene::Camera orbited(const scene::Camera& camera, double right, double up);
/// Moves eye and `look_at` in the plane of the picture, in units of its width there.
scene::Camera panned(const scene::Camera& camera, double right, double up);
/// Multiplies the distance to `look_at`, and the width of an orthographic view.
scene::Camera zoomed(const scene::Camera& camera, double factor);

/// The camera as it would be written: its position, and what differs from a camera's defaults.
std::string camera_text(const scene::Camera& camera);

} // namespace rt::tools::preview
