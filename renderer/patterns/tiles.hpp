#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Cubes of one unit, in two paints by turns, with joints between them. A joint ends where the next cube begins, so
/// that a surface at a whole number is one of tiles.
struct Tiles {
  static constexpr std::string_view noun = "tiles";
  static constexpr std::string_view help = "cubes of one unit, in two colours by turns, with joints between them";
  Paint a = white;
  Paint b = white;
  Paint mortar = grey(0.5);
  double joint = 0.05; ///< its width
};

std::span<const Field> fields(const Tiles*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space.
scene::Paint paint_at(const scene::Tiles& tiles, const Vec3& p);

} // namespace rt
