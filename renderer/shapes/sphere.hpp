#pragma once

#include "renderer/scene/field.hpp"

namespace rt::scene {

/// The points at `radius` from the origin of the shape's own space (its `at` is part of the placement).
struct Sphere {
  static constexpr std::string_view noun = "sphere";
  double radius = 1;
};

std::span<const Field> fields(const Sphere*);
std::optional<Problem> check(const Sphere&);

} // namespace rt::scene
