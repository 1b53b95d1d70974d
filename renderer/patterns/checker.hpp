#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Cubes of one unit, in two paints by turns.
struct Checker {
  static constexpr std::string_view noun = "checker";
  static constexpr std::string_view help = "cubes of one unit, in two colours by turns";
  Paint a = white;
  Paint b = black;
};

std::span<const Field> fields(const Checker*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space: a colour, or a pattern that decides there.
scene::Paint paint_at(const scene::Checker& checker, const Vec3& p);

} // namespace rt
