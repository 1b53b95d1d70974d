#pragma once

#include "renderer/patterns/chance/fractal.hpp"

namespace rt::scene {

/// Clouds: noise about the middle of the stops.
struct Noise : Fractal {
  static constexpr std::string_view noun = "noise";
  static constexpr std::string_view help = "soft clouds by chance, about one unit in size";
};

std::span<const Field> fields(const Noise*);

} // namespace rt::scene

namespace rt {

/// (1 + fractal noise)/2.
double value_at(const scene::Noise& noise, const Vec3& p);

} // namespace rt
