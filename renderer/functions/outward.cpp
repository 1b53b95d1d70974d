#include "renderer/functions/outward.hpp"

#include <initializer_list>

namespace rt {
namespace {

bool is_unbounded(const Enclosure& e) {
  return e.lower == -Enclosure::infinity || e.upper == Enclosure::infinity;
}

// A sum of two doubles is 0 only where it is exactly that.
double sum_below(double a, double b) {
  const double s = a + b;
  return s == 0 ? 0 : next_down(s);
}

// 0 times Enclosure::infinity is the limit of 0 times a large number.
double corner(double a, double b) {
  return a == 0 || b == 0 ? 0 : a * b;
}

// A product may be 0 because it is too small for a double, and then it still has a sign.
double product_below(double a, double b) {
  const double p = corner(a, b);
  return p == 0 && (a == 0 || b == 0 || (a < 0) == (b < 0)) ? 0 : next_down(p);
}
double product_above(double a, double b) {
  return -product_below(-a, b);
}

Enclosure corners(std::initializer_list<double> values, bool may_be_undefined) {
  return {std::min(values), std::max(values), may_be_undefined};
}

// The power by a whole number that is not 0.
Enclosure whole_power(const Enclosure& a, double n) {
  const bool is_even = std::fmod(n, 2) == 0;
  if (n < 0 && a.contains(0))
    return is_even ? Enclosure{0, Enclosure::infinity, a.may_be_undefined} : Enclosure::whole(a.may_be_undefined);
  const Enclosure base = is_even ? magnitude(a) : a;
  double low = std::pow(base.lower, n), high = std::pow(base.upper, n);
  if (n < 0) std::swap(low, high);
  const Enclosure e = outward(low, high, a.may_be_undefined, 2);
  if (base.lower >= 0) return held(e, 0, Enclosure::infinity);
  return e;
}

// Of a base that is not negative: monotone in the base and in the exponent, so that the extremes are at corners.
Enclosure positive_power(const Enclosure& a, const Enclosure& b, bool may_be_undefined) {
  const Enclosure e = corners(
      {std::pow(a.lower, b.lower), std::pow(a.lower, b.upper), std::pow(a.upper, b.lower), std::pow(a.upper, b.upper)},
      may_be_undefined);
  return held(outward(e.lower, e.upper, may_be_undefined, 2), 0, Enclosure::infinity);
}

} // namespace

Enclosure negated(const Enclosure& a) {
  return {-a.upper, -a.lower, a.may_be_undefined};
}

Enclosure magnitude(const Enclosure& a) {
  if (a.lower >= 0) return a;
  if (a.upper <= 0) return negated(a);
  return {0, std::max(-a.lower, a.upper), a.may_be_undefined};
}

Enclosure sum(const Enclosure& a, const Enclosure& b) {
  const bool has_opposite_infinities = (a.lower == -Enclosure::infinity && b.upper == Enclosure::infinity) ||
                                       (a.upper == Enclosure::infinity && b.lower == -Enclosure::infinity);
  return outward(sum_below(a.lower, b.lower), -sum_below(-a.upper, -b.upper),
                 a.may_be_undefined || b.may_be_undefined || has_opposite_infinities, 0);
}

Enclosure product(const Enclosure& a, const Enclosure& b) {
  const bool is_undefined_at_0 = (is_unbounded(a) && b.contains(0)) || (is_unbounded(b) && a.contains(0));
  return {std::min({product_below(a.lower, b.lower), product_below(a.lower, b.upper), product_below(a.upper, b.lower),
                    product_below(a.upper, b.upper)}),
          std::max({product_above(a.lower, b.lower), product_above(a.lower, b.upper), product_above(a.upper, b.lower),
                    product_above(a.upper, b.upper)}),
          a.may_be_undefined || b.may_be_undefined || is_undefined_at_0};
}

Enclosure square(const Enclosure& a) {
  const Enclosure m = magnitude(a);
  return {product_below(m.lower, m.lower), product_above(m.upper, m.upper), a.may_be_undefined};
}

Enclosure quotient(const Enclosure& a, const Enclosure& b) {
  const bool is_undefined = a.may_be_undefined || b.may_be_undefined || (is_unbounded(a) && is_unbounded(b));
  if (b.contains(0)) return Enclosure::whole(is_undefined || a.contains(0));
  if (is_unbounded(b)) { // 1/b first, which is finite
    const Enclosure inverse = outward(1 / b.upper, 1 / b.lower, b.may_be_undefined);
    return {product(a, inverse).lower, product(a, inverse).upper, is_undefined};
  }
  const Enclosure e =
      corners({a.lower / b.lower, a.lower / b.upper, a.upper / b.lower, a.upper / b.upper}, is_undefined);
  return outward(e.lower, e.upper, is_undefined);
}

// As computed, a − b·⌊a/b⌋: where the quotient's floor is one number, no more than that; else between 0 and b, but for
// rounding.
Enclosure remainder(const Enclosure& a, const Enclosure& b) {
  const Enclosure ratio = quotient(a, b);
  if (b.contains(0) || is_unbounded(a) || is_unbounded(b) || is_unbounded(ratio)) return Enclosure::whole(true);
  const bool is_undefined = a.may_be_undefined || b.may_be_undefined;
  const double turns = std::floor(ratio.lower);
  if (turns == std::floor(ratio.upper)) {
    const Enclosure e = sum(a, negated(product(b, Enclosure::of(turns))));
    return {e.lower, e.upper, is_undefined};
  }
  const double slack = 4 * std::numeric_limits<double>::epsilon() * (magnitude(a).upper + magnitude(b).upper);
  return outward(std::min(0.0, b.lower), std::max(0.0, b.upper), is_undefined, 0, slack);
}

Enclosure power(const Enclosure& a, const Enclosure& b) {
  const bool is_undefined = a.may_be_undefined || b.may_be_undefined;
  const bool is_constant = b.lower == b.upper && std::isfinite(b.lower);
  if (is_constant && b.lower == 0) return {1, 1, is_undefined};
  if (is_constant && b.lower == std::floor(b.lower)) return whole_power({a.lower, a.upper, is_undefined}, b.lower);
  if (a.lower == 0 && b.lower < 0 && !is_constant) return Enclosure::whole(is_undefined); // (−0)^−1 is −∞
  if (a.lower >= 0) return positive_power(a, b, is_undefined);
  if (!is_constant || a.upper < 0 || a.lower == -Enclosure::infinity) return Enclosure::whole(true);
  return positive_power({0, a.upper, true}, b, true);
}

} // namespace rt
