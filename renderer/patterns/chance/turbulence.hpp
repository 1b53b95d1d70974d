#pragma once

#include "renderer/patterns/chance/fractal.hpp"

namespace rt::scene {

/// Billows: the magnitude of noise, which has creases where noise is 0.
struct Turbulence : Fractal {
  static constexpr std::string_view noun = "turbulence";
  static constexpr std::string_view help = "billows by chance, with creases in them, about one unit in size";
};

std::span<const Field> fields(const Turbulence*);

} // namespace rt::scene

namespace rt {

/// The turbulence.
double value_at(const scene::Turbulence& turbulence, const Vec3& p);

} // namespace rt
