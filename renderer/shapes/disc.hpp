#pragma once

#include "renderer/scene/field.hpp"

namespace rt::scene {

/// The points of the plane through the origin of the shape's own space, perpendicular to `normal`, at a distance between
/// `hole` and `radius` from the origin, both included.
struct Disc {
  static constexpr std::string_view noun = "disc";
  Vec3 normal{0, 1, 0};
  double radius = 1;
  double hole = 0;
};

std::span<const Field> fields(const Disc*);
std::optional<Problem> check(const Disc&);

} // namespace rt::scene
