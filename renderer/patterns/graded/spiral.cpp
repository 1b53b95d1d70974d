#include "renderer/patterns/graded/spiral.hpp"

#include "renderer/math/degrees.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Spiral*) {
  static constexpr Field own[] = {
      field<&Spiral::arms>("arms",
                           {"1", "how many; negative: the other way about", {.is_whole = true, .is_nonzero = true}}),
  };
  static constexpr auto table = with_graded(own);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Spiral& spiral, const Vec3& p) {
  return within_period(spiral.arms * (atan2_degrees(-p.z, p.x) / 360) + std::hypot(p.x, p.z));
}

} // namespace rt
