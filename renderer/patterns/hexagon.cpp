#include "renderer/patterns/hexagon.hpp"

#include <cmath>
#include <numbers>

namespace rt::scene {

std::span<const Field> fields(const Hexagon*) {
  static constexpr Field table[] = {
      field<&Hexagon::a>("a", {"white", "colour, number or pattern of the hexagon about y", not_negative}),
      field<&Hexagon::b>("b", {"0.5", "of its neighbour in z, and by turns", not_negative}),
      field<&Hexagon::c>("c", {"black", "of that one's", not_negative}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {

// The middles are q·(3/2, √3/2) + r·(0, √3). Of the three coordinates q, r and −q − r, rounded, the one that rounding
// moved most is what the other two ask for (A. Patel, Hexagonal Grids, Red Blob Games: cube rounding). From one hexagon
// to the next, r − q grows by 1 or by 2, modulo 3.
scene::Paint paint_at(const scene::Hexagon& hexagon, const Vec3& p) {
  const double q = p.x * (2.0 / 3), r = p.z * std::numbers::inv_sqrt3 - p.x / 3, s = -q - r;
  double whole_q = std::round(q), whole_r = std::round(r);
  const double whole_s = std::round(s);
  const double moved_q = std::abs(whole_q - q), moved_r = std::abs(whole_r - r), moved_s = std::abs(whole_s - s);
  if (moved_q > moved_r && moved_q > moved_s)
    whole_q = -whole_r - whole_s;
  else if (moved_r > moved_s)
    whole_r = -whole_q - whole_s;
  const double turn = std::fmod(whole_r - whole_q, 3);
  if (turn == 0) return hexagon.a;
  return turn == 1 || turn == -2 ? hexagon.b : hexagon.c;
}

} // namespace rt
