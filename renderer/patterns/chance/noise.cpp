#include "renderer/patterns/chance/noise.hpp"

#include <algorithm>

namespace rt::scene {

std::span<const Field> fields(const Noise*) {
  static constexpr auto table = with_graded(fractal_fields);
  return table;
}

} // namespace rt::scene

namespace rt {

double value_at(const scene::Noise& noise, const Vec3& p) {
  return std::clamp((1 + fractal_noise(noise, p)) / 2, 0.0, 1.0);
}

} // namespace rt
