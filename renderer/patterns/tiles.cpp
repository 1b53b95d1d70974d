#include "renderer/patterns/tiles.hpp"

#include <algorithm>
#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Tiles*) {
  static constexpr Field table[] = {
      field<&Tiles::a>("a", {"white", "first colour, number or pattern", not_negative}),
      field<&Tiles::b>("b", {"white", "second colour, number or pattern", not_negative}),
      field<&Tiles::mortar>("mortar", {"0.5", "colour, number or pattern of the joints", not_negative}),
      field<&Tiles::joint>("joint",
                           {"0.05", "width of the joints, of which each is below a whole number", zero_to_one}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {

// The same small shift as the checker's.
scene::Paint paint_at(const scene::Tiles& tiles, const Vec3& p) {
  double cells = 0, farthest = 0;
  for (const double coordinate : {p.x, p.y, p.z}) {
    const double shifted = coordinate + 1e-10, whole = std::floor(shifted);
    cells += whole;
    farthest = std::max(farthest, shifted - whole);
  }
  if (farthest >= 1 - tiles.joint) return tiles.mortar;
  return std::fmod(cells, 2) == 0 ? tiles.a : tiles.b;
}

} // namespace rt
