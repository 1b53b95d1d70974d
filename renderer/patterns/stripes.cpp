#include "renderer/patterns/stripes.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Stripes*) {
  static constexpr Field table[] = {
      field<&Stripes::a>("a", {"white", "first colour, number or pattern", not_negative}),
      field<&Stripes::b>("b", {"black", "second colour, number or pattern", not_negative}),
      field<&Stripes::width>("width", {"0.5", "of the first; the second has the rest", zero_to_one}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {

// The same small shift as the checker's.
scene::Paint paint_at(const scene::Stripes& stripes, const Vec3& p) {
  const double x = p.x + 1e-10;
  return x - std::floor(x) < stripes.width ? stripes.a : stripes.b;
}

} // namespace rt
