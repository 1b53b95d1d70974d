#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Balls about all points with whole coordinates.
struct Dots {
  static constexpr std::string_view noun = "dots";
  static constexpr std::string_view help = "dots about all points with whole coordinates, in a ground";
  Paint ground = white;
  Paint color = black;
  double radius = 0.3;
};

std::span<const Field> fields(const Dots*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space.
scene::Paint paint_at(const scene::Dots& dots, const Vec3& p);

} // namespace rt
