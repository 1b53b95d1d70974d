#include "renderer/patterns/graded/gradient.hpp"

#include "renderer/math/degrees.hpp"

#include <algorithm>
#include <cmath>

namespace rt::scene {

std::span<const Field> fields(const Gradient*) {
  static constexpr std::string_view kinds[] = {"linear", "radial", "spherical", "cylindrical", "angular", "box"};
  static constexpr Field own[] = {
      field<&Gradient::kind>("kind", {.default_text = "linear",
                                      .help = "along the direction; about y; from the middle; from y; by the angle "
                                              "with y; from the middle in cubes",
                                      .choices = kinds}),
      field<&Gradient::direction>("direction", {"[0, 1, 0]", "of a linear one", nonzero}),
      field<&Gradient::repeat>("repeat", {"true", "false: a linear one holds what it shows at its ends"}),
  };
  static constexpr auto table = with_graded(own);
  return table;
}

} // namespace rt::scene

namespace rt {
namespace {

double linear_value(const scene::Gradient& gradient, const Vec3& p) {
  const double way = dot(p, normalize(gradient.direction));
  return gradient.repeat ? within_period(way) : std::clamp(way, 0.0, 1.0);
}

double falling(double distance) {
  return 1 - std::min(distance, 1.0);
}

} // namespace

double value_at(const scene::Gradient& gradient, const Vec3& p) {
  using Kind = scene::Gradient::Kind;
  switch (gradient.kind) {
  case Kind::linear:
    return linear_value(gradient, p);
  case Kind::radial:
    return within_period(atan2_degrees(-p.z, p.x) / 360);
  case Kind::spherical:
    return falling(length(p));
  case Kind::cylindrical:
    return falling(std::hypot(p.x, p.z));
  case Kind::angular:
    return atan2_degrees(std::hypot(p.x, p.z), p.y) / 180;
  case Kind::box:
    return falling(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  }
  return 0;
}

} // namespace rt
