#include "renderer/patterns/chance/turbulence.hpp"

#include <algorithm>

namespace rt::scene {

std::span<const Field> fields(const Turbulence*) {
  static constexpr auto table = with_graded(fractal_fields);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Turbulence& pattern, const Vec3& p) {
  return std::min(turbulence(pattern, p), 1.0);
}

} // namespace rt
