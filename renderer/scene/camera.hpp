#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

enum class Projection : std::uint8_t { perspective, orthographic };

/// A view of the scene, without lens or tilt. Image x runs to the right, y down; the picture is not mirrored.
struct Camera {
  Vec3 at{0, 1, 6};
  Vec3 look_at{};
  Vec3 up{0, 1, 0};
  double fov = 50; ///< horizontal, degrees
  Projection projection = Projection::perspective;
  double width = 4; ///< of an orthographic view, in scene lengths
};

std::span<const Field> fields(const Camera*);
std::optional<Problem> check(const Camera&);

} // namespace rt::scene
