#pragma once

#include "renderer/functions/opcode.hpp"
#include "renderer/math/degrees.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {

/// x held between −1 and 1, where rounding may have carried a sine or cosine a little beyond; not a number where it is
/// none.
inline double as_sine(double x) {
  constexpr double slack = 1e-12;
  if (!(std::abs(x) <= 1 + slack)) return std::numeric_limits<double>::quiet_NaN();
  return std::clamp(x, -1.0, 1.0);
}

/// The value of an operation but `noise`: the same, to the last bit, as the language gives. Not a number where it has
/// none (the root of a negative number).
template <Opcode operation>
double apply(double a, [[maybe_unused]] double b, [[maybe_unused]] double c) {
  using enum Opcode;
  static_assert(operation != noise);
  if constexpr (operation == negate) return -a;
  if constexpr (operation == absolute) return std::abs(a);
  if constexpr (operation == Opcode::floor) return std::floor(a);
  if constexpr (operation == Opcode::ceil) return std::ceil(a);
  if constexpr (operation == Opcode::round) return std::round(a);
  if constexpr (operation == square_root) return std::sqrt(a);
  if constexpr (operation == sine) return sin_degrees(a);
  if constexpr (operation == cosine) return cos_degrees(a);
  if constexpr (operation == tangent) return tan_degrees(a);
  if constexpr (operation == arc_sine) return asin_degrees(as_sine(a));
  if constexpr (operation == arc_cosine) return acos_degrees(as_sine(a));
  if constexpr (operation == arc_tangent) return atan_degrees(a);
  if constexpr (operation == exponential) return std::exp(a);
  if constexpr (operation == logarithm) return std::log(a);
  if constexpr (operation == logarithm2) return std::log2(a);
  if constexpr (operation == logarithm10) return std::log10(a);
  if constexpr (operation == not_) return a == 0 ? 1 : 0;
  if constexpr (operation == add) return a + b;
  if constexpr (operation == subtract) return a - b;
  if constexpr (operation == multiply) return a * b;
  if constexpr (operation == divide) return a / b;
  if constexpr (operation == modulo) return a - b * std::floor(a / b);
  if constexpr (operation == power) return std::pow(a, b);
  if constexpr (operation == minimum) return std::min(a, b);
  if constexpr (operation == maximum) return std::max(a, b);
  if constexpr (operation == arc_tangent2) return atan2_degrees(a, b);
  if constexpr (operation == hypotenuse) return std::hypot(a, b);
  if constexpr (operation == Opcode::less) return a < b ? 1 : 0;
  if constexpr (operation == Opcode::less_equal) return a <= b ? 1 : 0;
  if constexpr (operation == equal) return a == b ? 1 : 0;
  if constexpr (operation == and_) return a != 0 && b != 0 ? 1 : 0;
  if constexpr (operation == or_) return a != 0 || b != 0 ? 1 : 0;
  if constexpr (operation == select) return a != 0 ? b : c;
}

} // namespace rt
