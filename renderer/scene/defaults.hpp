#pragma once

#include "renderer/scene/scene.hpp"

#include <string>

namespace rt::scene {

/// Gives a scene without a camera a default one, looking down on it from three-quarters above: with c the centre of
/// `finite_bounds` and R half its diagonal, the eye is at c + 1.1 R / sin(a/2) · (0.5, 0.45, 1)/|(0.5, 0.45, 1)| and
/// looks at c, where a is the smaller of the picture's two angles of view: the bounding sphere fits into the picture.
/// If nothing is finite, the camera's defaults apply. Returns a note that says so.
std::string assume_camera(Scene& scene, const Box3& finite_bounds);

/// Whether the scene would be black for lack of light: there is no lamp, and `ambient` is not specified, or in path
/// mode, which has no ambient light, nothing emits light and the background is black.
bool lacks_light(const Scene& scene, bool has_ambient);

/// Gives a scene a sun. Returns a note that says so.
std::string assume_light(Scene& scene);

} // namespace rt::scene
