#include "renderer/patterns/graded/leopard.hpp"

#include "renderer/math/degrees.hpp"

#include <numbers>

namespace rt::scene {

std::span<const Field> fields(const Leopard*) {
  return graded_fields;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Leopard&, const Vec3& p) {
  const Vec3 degrees = p * (180 / std::numbers::pi);
  const double mean = (sin_degrees(degrees.x) + sin_degrees(degrees.y) + sin_degrees(degrees.z)) / 3;
  return mean * mean;
}

} // namespace rt
