#include "renderer/patterns/checker.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Checker*) {
  static constexpr Field table[] = {
      field<&Checker::a>("a", {"white", "first colour, number or pattern", not_negative}),
      field<&Checker::b>("b", {"black", "second colour, number or pattern", not_negative}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {

// The small shift before rounding keeps a floor at a whole number stable, and is POV-Ray's own.
scene::Paint paint_at(const scene::Checker& checker, const Vec3& p) {
  const double cells = std::floor(p.x + 1e-10) + std::floor(p.y + 1e-10) + std::floor(p.z + 1e-10);
  return std::fmod(cells, 2) == 0 ? checker.a : checker.b;
}

} // namespace rt
