#include "renderer/patterns/chance/marble.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Marble*) {
  static constexpr Field own[] = {
      field<&Marble::wander>("wander", {"1", "how far the veins are moved by turbulence, at most", not_negative}),
  };
  static constexpr auto table = with_fractal(own);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Marble& marble, const Vec3& p) {
  const double u = p.x + marble.wander * turbulence(marble, p);
  return std::abs(1 - 2 * (u - std::floor(u)));
}

} // namespace rt
