#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/elementary.hpp"

#include <algorithm>

namespace rt {

/// What a medium takes of light that goes through it (A. Beer, J. Lambert): e^(−σ·t) of it is left after a length t.
struct Absorption {
  Color sigma = black; ///< for each length of the scene

  Color left_after(double length) const {
    const auto left = [length](double s) { return s * length < 700 ? exponential_decay(s * length) : 0; };
    return {left(sigma.r), left(sigma.g), left(sigma.b)};
  }
};

} // namespace rt
