#include "renderer/patterns/graded/onion.hpp"

#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Onion*) {
  return graded_fields;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Onion&, const Vec3& p) {
  return std::fmod(length(p), 1);
}

} // namespace rt
