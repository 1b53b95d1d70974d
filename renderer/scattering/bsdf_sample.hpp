#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"

namespace rt {

/// A direction in which light is looked for, in the frame of the surface.
struct BsdfSample {
  Vec3 wi{};
  Color weight = black;     ///< f·|cos| by density
  double density = 0;       ///< per solid angle; of a perfect mirror or glass the probability of this branch
  bool is_perfect = false;  ///< a single direction: no other way finds it
  bool is_straight = false; ///< through a sheet or between media of one ior: the ray goes on as if nothing were there
};

} // namespace rt
