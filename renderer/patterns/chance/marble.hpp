#pragma once

#include "renderer/patterns/chance/fractal.hpp"

namespace rt::scene {

/// Veins across the x axis, one unit apart, that wander.
struct Marble : Fractal {
  static constexpr std::string_view noun = "marble";
  static constexpr std::string_view help =
      "veins across the x axis, which are 1, in a ground of 0; they are one unit apart";
  double wander = 1;
};

std::span<const Field> fields(const Marble*);

} // namespace rt::scene

namespace rt {

/// With u = x + wander · turbulence: 1 where u is whole, and half way between 0.
double value_at(const scene::Marble& marble, const Vec3& p);

} // namespace rt
