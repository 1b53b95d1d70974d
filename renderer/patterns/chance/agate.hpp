#pragma once

#include "renderer/patterns/chance/fractal.hpp"

namespace rt::scene {

/// Bands across the y axis that wander, and are sharper on one side.
struct Agate : Fractal {
  static constexpr std::string_view noun = "agate";
  static constexpr std::string_view help = "bands across the y axis that wander, about one unit wide";
  double wander = 1.3;
};

std::span<const Field> fields(const Agate*);

} // namespace rt::scene

namespace rt {

/// ((1 + sin 2π(1.1y + wander · turbulence))/2)^0.77, the form that POV-Ray's has.
double value_at(const scene::Agate& agate, const Vec3& p);

} // namespace rt
