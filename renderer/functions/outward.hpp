#pragma once

#include "renderer/functions/enclosure.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

/// Rounding away from the inside of an interval, without touching the processor's rounding mode.
namespace rt {

/// The next double above; infinity stays.
inline double next_up(double x) {
  if (!(x < Enclosure::infinity)) return x;
  const auto bits = std::bit_cast<std::int64_t>(x + 0.0);
  return std::bit_cast<double>(bits >= 0 ? bits + 1 : bits - 1);
}
inline double next_down(double x) {
  return -next_up(-x);
}

/// The interval, wider by `steps` doubles and then by `slack` at each end. Bounds that are no numbers become infinite.
inline Enclosure outward(double lower, double upper, bool may_be_undefined, int steps = 1, double slack = 0) {
  Enclosure e{std::isnan(lower) ? -Enclosure::infinity : lower, std::isnan(upper) ? Enclosure::infinity : upper,
              may_be_undefined};
  for (int i = 0; i < steps; ++i) e.lower = next_down(e.lower), e.upper = next_up(e.upper);
  e.lower -= slack;
  e.upper += slack;
  return e;
}

/// What of it lies from `lower` to `upper`, where all of it is known to be.
inline Enclosure held(const Enclosure& e, double lower, double upper) {
  return {std::clamp(e.lower, lower, upper), std::clamp(e.upper, lower, upper), e.may_be_undefined};
}

/// Of arithmetic.
Enclosure sum(const Enclosure& a, const Enclosure& b);
Enclosure negated(const Enclosure& a);
Enclosure product(const Enclosure& a, const Enclosure& b);
Enclosure square(const Enclosure& a);
Enclosure quotient(const Enclosure& a, const Enclosure& b);
Enclosure remainder(const Enclosure& a, const Enclosure& b);
Enclosure power(const Enclosure& base, const Enclosure& exponent);
Enclosure magnitude(const Enclosure& a);

/// Of angles in degrees.
Enclosure sine(const Enclosure& a);
Enclosure cosine(const Enclosure& a);
Enclosure tangent(const Enclosure& a);
Enclosure arc_sine(const Enclosure& a);
Enclosure arc_cosine(const Enclosure& a);
Enclosure arc_tangent(const Enclosure& a);
Enclosure arc_tangent2(const Enclosure& y, const Enclosure& x);

} // namespace rt
