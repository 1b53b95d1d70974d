#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/color.hpp"
#include "renderer/math/elementary.hpp"

#include <algorithm>

namespace rt {

/// A medium's absorption (A. Beer, J. Lambert): its transmittance over a length t is e^(−σ·t).
struct Absorption {
  Color sigma = black; ///< per scene unit of length

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
  // What transmits nothing is treated as very dense.
  static double depth(double left) { return left >= 1 ? 0 : -natural_logarithm(std::max(left, 1e-300)); }
};

} // namespace rt
