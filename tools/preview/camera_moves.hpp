#pragma once

#include "renderer/scene/camera.hpp"

#include <string>

/// A camera that is moved by hand. What it looks at stays in the middle of the picture, unless it is panned.
namespace rt::tools::preview {

/// The eye goes round `look_at`, in degrees: to its right, and upwards as far as a degree from straight above or below.
scene::Camera orbited(const scene::Camera& camera, double right, double up);
/// Eye and `look_at` move in the plane of the picture, in widths of what is seen there.
scene::Camera panned(const scene::Camera& camera, double right, double up);
/// The distance to `look_at` is multiplied, and the width of an orthographic view.
scene::Camera zoomed(const scene::Camera& camera, double factor);

/// The camera as it would be written: where it stands, and what differs from a camera's defaults.
std::string camera_text(const scene::Camera& camera);

} // namespace rt::tools::preview
