#pragma once

#include "renderer/scene/scene.hpp"

#include <string>

namespace rt::lang {

/// The view of a scene that has no camera of its own, looking down on it from three-quarters above: with c the centre
/// of the bounding box of the finite visible shapes and R half of its diagonal, the eye stands at c + 1.1 R / sin(a/2)
/// · (0.5, 0.45, 1)/|(0.5, 0.45, 1)| and looks at c, where a is the smaller of the picture's two angles of view: the
/// bounding sphere fits into the picture. Where there is nothing finite, it is the camera's defaults.
scene::Camera framing_camera(const scene::Scene& scene);
/// The same for a bounding box that is known already.
scene::Camera framing_camera(const Box3& box, scene::Resolution size);

/// The light of a scene that has none, and whose `ambient` is not written.
scene::Light key_sun();

/// What they are, for a note: "looking from [1, 2, 3] at [0, 0, 0]".
std::string describe_camera(const scene::Camera& camera);
std::string describe_sun(const scene::Light& light);

} // namespace rt::lang
