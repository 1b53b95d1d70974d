#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

enum class Projection : std::uint8_t { perspective, orthographic };

/// A view of the scene, without roll. In path mode it may have a lens: then what is in front of or behind the plane of
/// focus, which is perpendicular to the view direction, is blurred. Image x runs to the right, y down; the picture is
/// not mirrored.
struct Camera {
  Vec3 at{0, 1, 6};
  Vec3 look_at{};
  Vec3 up{0, 1, 0};
  double fov = 50; ///< horizontal, degrees
  Projection projection = Projection::perspective;
  double width = 4;                    ///< of an orthographic view, in scene units
  std::optional<double> aperture = {}; ///< the lens's diameter; 0
  std::optional<Vec3> focus_at = {};   ///< a point of the plane of focus
  std::optional<double> focus = {};    ///< or its distance; with neither it passes through `look_at`
};

/// The distance of the plane of focus along the view direction.
double focus_distance(const Camera& camera);

std::span<const Field> fields(const Camera*);
std::optional<Problem> check(const Camera&);

} // namespace rt::scene
