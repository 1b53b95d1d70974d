#include "renderer/patterns/chance/granite.hpp"

#include <algorithm>

namespace rt::scene {

std::span<const Field> fields(const Granite*) {
  static constexpr auto table = with_graded(fractal_fields);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Granite& granite, const Vec3& p) {
  return std::min(2 * turbulence(granite, p * 4), 1.0);
}

} // namespace rt
