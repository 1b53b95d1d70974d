#include "renderer/patterns/graded/rings.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Rings*) {
  return graded_fields;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Rings&, const Vec3& p) {
  return std::fmod(std::hypot(p.x, p.z), 1);
}

} // namespace rt
