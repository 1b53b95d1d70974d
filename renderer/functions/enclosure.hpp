#pragma once

#include "renderer/functions/evaluate.hpp"

#include <algorithm>
#include <limits>

namespace rt {

/// An interval that surely holds all values that a function takes where its inputs lie in intervals (Moore, Kearfott,
/// Cloud, Introduction to Interval Analysis): the exact ones, and those that `evaluate` gives. The bounds are in it,
/// and may be infinite, but are always numbers.
struct Enclosure {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double lower = -infinity, upper = infinity;
  /// Somewhere the function may have no value (the root of a negative number).
  bool may_be_undefined = false;

  static constexpr Enclosure of(double value) { return {value, value, false}; }
  static constexpr Enclosure whole(bool may_be_undefined) { return {-infinity, infinity, may_be_undefined}; }
  constexpr bool contains(double x) const { return x >= lower && x <= upper; }
  friend constexpr bool operator==(const Enclosure&, const Enclosure&) = default;
};

/// Both, and all that is between.
constexpr Enclosure hull(const Enclosure& a, const Enclosure& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper), a.may_be_undefined || b.may_be_undefined};
}

/// Over intervals of the inputs.
void evaluate(const Function& function, std::span<const Enclosure> inputs, Registers<Enclosure> registers);

} // namespace rt
