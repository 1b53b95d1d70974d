#include "renderer/patterns/dots.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Dots*) {
  static constexpr Field table[] = {
      field<&Dots::ground>("ground", {"white", "colour, number or pattern between the dots", not_negative}),
      field<&Dots::color>("color", {"black", "colour, number or pattern of the dots", not_negative}),
      field<&Dots::radius>("radius", {"0.3", "of a dot; from 0.5 on they meet", positive}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {

scene::Paint paint_at(const scene::Dots& dots, const Vec3& p) {
  const Vec3 nearest{std::floor(p.x + 0.5), std::floor(p.y + 0.5), std::floor(p.z + 0.5)};
  return length(p - nearest) < dots.radius ? dots.color : dots.ground;
}

} // namespace rt
