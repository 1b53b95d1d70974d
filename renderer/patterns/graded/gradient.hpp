#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// A value that changes evenly in space.
struct Gradient : Graded {
  enum class Kind : std::uint8_t { linear, radial, spherical, cylindrical, angular, box };
  static constexpr std::string_view noun = "gradient";
  static constexpr std::string_view help = "through the stops along a way, about an axis, or from the middle outwards";
  Kind kind = Kind::linear;
  Vec3 direction{0, 1, 0};
  bool repeat = true;
};

std::span<const Field> fields(const Gradient*);

} // namespace rt::scene

namespace rt {

/// Linear: the way along the direction, in units. Radial: the angle about the y axis, in turns from x towards −z.
/// Angular: the angle from the y axis, in half turns. Spherical, cylindrical, box: 1 at the origin, or on the y axis,
/// and 0 from a distance of one unit on, for the box by the largest coordinate.
double value_at(const scene::Gradient& gradient, const Vec3& p);

} // namespace rt
