#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Bricks in courses along y, every other course moved by half a brick; mortar between them, below and before each.
struct Brick {
  static constexpr std::string_view noun = "brick";
  static constexpr std::string_view help = "a wall of bricks, every other course moved by half of one";
  Paint mortar = grey(0.5);
  Paint color = Color{0.3, 0.05, 0.03};
  Vec3 size{0.6, 0.2, 0.3}; ///< from one brick to the next, mortar included
  double joint = 0.03;      ///< width of the mortar
};

std::span<const Field> fields(const Brick*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space.
scene::Paint paint_at(const scene::Brick& brick, const Vec3& p);

} // namespace rt
