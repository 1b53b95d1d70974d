#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

namespace rt {

/// A sampled direction, in the frame of the surface.
struct BsdfSample {
  Vec3 wi{};
  Color weight = black;     ///< f·|cos| divided by the density
  double density = 0;       ///< per solid angle; for a perfect mirror or glass the probability of this branch
  bool is_perfect = false;  ///< a delta distribution: no other strategy finds it
  bool is_straight = false; ///< through a sheet or between media of equal ior: the ray goes on as if nothing were there
};

} // namespace rt
