#pragma once

#include "renderer/patterns/chance/fractal.hpp"

namespace rt::scene {

/// Grains: turbulence with much of it fine.
struct Granite : Fractal {
  static constexpr std::string_view noun = "granite";
  static constexpr std::string_view help = "grains by chance, the largest a quarter of a unit";
};

std::span<const Field> fields(const Granite*);

} // namespace rt::scene

namespace rt {

/// Turbulence at four times the point, doubled, and held at 1.
double value_at(const scene::Granite& granite, const Vec3& p);

} // namespace rt
