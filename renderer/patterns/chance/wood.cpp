#include "renderer/patterns/chance/wood.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Wood*) {
  static constexpr Field own[] = {
      field<&Wood::wander>("wander", {"0.4", "how far from round the rings are, at most", not_negative}),
      field<&Wood::grain>("grain", {"0.2", "the share of fibres", zero_to_one}),
  };
  static constexpr auto table = with_fractal(own);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Wood& wood, const Vec3& p) {
  const Vec3 slow{p.x / 2, p.y / 8, p.z / 2};
  const double x = p.x + wood.wander * fractal_noise(wood, slow, 0),
               z = p.z + wood.wander * fractal_noise(wood, slow, 1);
  const double r = std::hypot(x, z), ring = r - std::floor(r);
  const double season = ring < 0.8 ? ring / 0.8 : (1 - ring) / 0.2;
  const double fibre = (1 + fractal_noise(wood, {12 * p.x, p.y / 2, 12 * p.z}, 2)) / 2;
  return season + (fibre - season) * wood.grain;
}

} // namespace rt
