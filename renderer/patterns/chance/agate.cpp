#include "renderer/patterns/chance/agate.hpp"

#include "renderer/math/degrees.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Agate*) {
  static constexpr Field own[] = {
      field<&Agate::wander>("wander", {"1.3", "how far the bands are moved by turbulence, at most", not_negative}),
  };
  static constexpr auto table = with_fractal(own);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Agate& agate, const Vec3& p) {
  return std::pow((1 + sin_degrees(360 * (1.1 * p.y + agate.wander * turbulence(agate, p)))) / 2, 0.77);
}

} // namespace rt
