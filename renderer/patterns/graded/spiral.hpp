#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Arms about the y axis, each one unit wide.
struct Spiral : Graded {
  static constexpr std::string_view noun = "spiral";
  static constexpr std::string_view help =
      "arms about the y axis; outwards, each is one unit and once through the stops";
  int arms = 1;
};

std::span<const Field> fields(const Spiral*);

} // namespace rt::scene

namespace rt {

/// What is left of the distance from the y axis and, for each arm, of the angle about it from x (in turns), after whole
/// ones.
double value_at(const scene::Spiral& spiral, const Vec3& p);

} // namespace rt
