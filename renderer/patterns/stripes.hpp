#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Slabs across the x axis, in two paints by turns; both together are one unit wide.
struct Stripes {
  static constexpr std::string_view noun = "stripes";
  static constexpr std::string_view help = "stripes across the x axis in two colours by turns, one unit for both";
  Paint a = white;
  Paint b = black;
  double width = 0.5; ///< of the first
};

std::span<const Field> fields(const Stripes*);

} // namespace rt::scene

namespace rt {

/// What it shows at `p`, a point of its own space.
scene::Paint paint_at(const scene::Stripes& stripes, const Vec3& p);

} // namespace rt
