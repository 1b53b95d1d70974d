#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Prisms along y over hexagons with sides of one unit, in three paints of which no two neighbours have the same; the
/// first stands about the y axis, with corners on the x axis.
struct Hexagon {
  static constexpr std::string_view noun = "hexagon";
  static constexpr std::string_view help = "hexagons with sides of one unit about the y axis, in three colours";
  Paint a = white;
  Paint b = grey(0.5);
  Paint c = black;
};

std::span<const Field> fields(const Hexagon*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space.
scene::Paint paint_at(const scene::Hexagon& hexagon, const Vec3& p);

} // namespace rt
