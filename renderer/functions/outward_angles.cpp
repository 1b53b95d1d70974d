#include "renderer/functions/apply.hpp"
#include "renderer/functions/outward.hpp"

#include <initializer_list>

namespace rt {
namespace {

// Bounds on the errors of the functions of `degrees.hpp`: a sine's is absolute, because the angle is rounded when it
// becomes radians; an arc may be moved to a whole number of degrees that has the same sine to the last bit.
constexpr double sine_slack = 1e-15, arc_slack = 1e-12;

// Whether a + 360·k lies in the interval for a whole k; not so wide as to miss any.
bool holds_angle(double lower, double width, double angle) {
  constexpr double slack = 1e-12;
  const double difference = std::fmod(angle - lower, 360.0), ahead = difference < 0 ? difference + 360 : difference;
  return ahead <= width + slack || ahead >= 360 - slack;
}

Enclosure wave(const Enclosure& a, double peak, double (*f)(double)) {
  const double width = a.upper - a.lower;
  const bool is_unbounded = !std::isfinite(a.lower) || !std::isfinite(a.upper);
  if (is_unbounded || !(width < 360)) return {-1, 1, a.may_be_undefined || is_unbounded};
  // The remainder of a double by 360 is exact.
  const double start = std::fmod(a.lower, 360.0), end_width = next_up(width);
  const double at_lower = f(a.lower), at_upper = f(a.upper);
  Enclosure e = outward(std::min(at_lower, at_upper), std::max(at_lower, at_upper), a.may_be_undefined, 2, sine_slack);
  if (holds_angle(start, end_width, peak)) e.upper = 1;
  if (holds_angle(start, end_width, peak + 180)) e.lower = -1;
  return held(e, -1, 1);
}

Enclosure increasing(double lower, double upper, bool may_be_undefined) {
  return outward(lower, upper, may_be_undefined, 2, arc_slack);
}

} // namespace

Enclosure sine(const Enclosure& a) {
  return wave(a, 90, sin_degrees);
}
Enclosure cosine(const Enclosure& a) {
  return wave(a, 0, cos_degrees);
}

// Monotone between its poles; at an end, it is known as well as its sine and cosine are.
Enclosure tangent(const Enclosure& a) {
  const double width = a.upper - a.lower;
  const bool is_unbounded = !std::isfinite(a.lower) || !std::isfinite(a.upper);
  if (is_unbounded || !(width < 180)) return Enclosure::whole(a.may_be_undefined || is_unbounded);
  const double start = std::fmod(a.lower, 360.0), end_width = next_up(width);
  if (holds_angle(start, end_width, 90) || holds_angle(start, end_width, 270))
    return Enclosure::whole(a.may_be_undefined);
  const auto at = [](double angle) {
    return quotient(rt::sine(Enclosure::of(angle)), rt::cosine(Enclosure::of(angle)));
  };
  Enclosure e = hull(at(a.lower), at(a.upper));
  e.may_be_undefined = a.may_be_undefined;
  return e;
}

Enclosure arc_sine(const Enclosure& a) {
  if (a.lower > 1 || a.upper < -1) return Enclosure{-90, 90, true};
  const bool is_undefined = a.may_be_undefined || a.lower < -1 || a.upper > 1;
  return held(increasing(asin_degrees(std::max(a.lower, -1.0)), asin_degrees(std::min(a.upper, 1.0)), is_undefined),
              -90, 90);
}
Enclosure arc_cosine(const Enclosure& a) {
  if (a.lower > 1 || a.upper < -1) return Enclosure{0, 180, true};
  const bool is_undefined = a.may_be_undefined || a.lower < -1 || a.upper > 1;
  return held(increasing(acos_degrees(std::min(a.upper, 1.0)), acos_degrees(std::max(a.lower, -1.0)), is_undefined), 0,
              180);
}
Enclosure arc_tangent(const Enclosure& a) {
  return held(increasing(atan_degrees(a.lower), atan_degrees(a.upper), a.may_be_undefined), -90, 90);
}

// Where the box does not meet the cut along the negative x axis, the extremes are at its corners.
Enclosure arc_tangent2(const Enclosure& y, const Enclosure& x) {
  const bool is_undefined = y.may_be_undefined || x.may_be_undefined;
  if (x.lower <= 0 && y.contains(0)) return {-180, 180, is_undefined};
  const auto values = {atan2_degrees(y.lower, x.lower), atan2_degrees(y.lower, x.upper),
                       atan2_degrees(y.upper, x.lower), atan2_degrees(y.upper, x.upper)};
  return held(increasing(std::min(values), std::max(values), is_undefined), -180, 180);
}

} // namespace rt
