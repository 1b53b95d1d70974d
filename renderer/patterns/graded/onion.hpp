#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Shells about the origin, one unit thick.
struct Onion : Graded {
  static constexpr std::string_view noun = "onion";
  static constexpr std::string_view help = "shells about its middle, each one unit thick and once through the stops";
};

std::span<const Field> fields(const Onion*);

} // namespace rt::scene

namespace rt {

/// What is left of the distance from the origin after whole units.
double value_at(const scene::Onion& onion, const Vec3& p);

} // namespace rt
