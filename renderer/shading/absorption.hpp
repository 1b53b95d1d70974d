#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/color.hpp"
#include "renderer/math/elementary.hpp"

#include <algorithm>

namespace rt {

/// What a medium takes of light that goes through it (A. Beer, J. Lambert): e^(−σ·t) of it is left after a length t.
struct Absorption {
  Color sigma = black; ///< for each length of the scene

  Absorption() = default;
  explicit Absorption(const Color& s) : sigma(s) {}
  explicit Absorption(const scene::Absorb& absorb)
      : sigma(Color{depth(absorb.color.r), depth(absorb.color.g), depth(absorb.color.b)} * (1 / absorb.distance)) {}

  bool is_clear() const { return sigma == black; }

  Color left_after(double length) const {
    const auto left = [length](double s) { return s * length < 700 ? exponential_decay(s * length) : 0; };
    return {left(sigma.r), left(sigma.g), left(sigma.b)};
  }

private:
  // What leaves nothing is very dense.
  static double depth(double left) { return left >= 1 ? 0 : -natural_logarithm(std::max(left, 1e-300)); }
};

} // namespace rt
