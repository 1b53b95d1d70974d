#pragma once

#include "renderer/patterns/graded/graded.hpp"

namespace rt::scene {

/// Waves that run out in circles from points by chance.
struct Ripples : Graded {
  static constexpr std::string_view noun = "ripples";
  static constexpr std::string_view help = "waves that run out from points by chance, one unit long";
  int sources = 10;
  double spread = 0; ///< of their lengths
  int seed = 0;
};

std::span<const Field> fields(const Ripples*);

} // namespace rt::scene

namespace rt {

/// (1 + Σ lᵢ sin 2π(dᵢ/lᵢ) / Σ lᵢ)/2: dᵢ is the distance from the point i, which lies in the cube from −2 to 2, and lᵢ
/// is between 1/(1 + spread) and 1 + spread.
double value_at(const scene::Ripples& ripples, const Vec3& p);

} // namespace rt
