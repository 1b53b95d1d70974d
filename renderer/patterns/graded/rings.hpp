#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Tubes about the y axis, one unit thick.
struct Rings : Graded {
  static constexpr std::string_view noun = "rings";
  static constexpr std::string_view help = "rings about the y axis, each one unit wide and once through the stops";
};

std::span<const Field> fields(const Rings*);

} // namespace rt::scene

namespace rt {

/// What is left of the distance from the y axis after whole units.
double value_at(const scene::Rings& rings, const Vec3& p);

} // namespace rt
