#include "lang/builtins/builtins.hpp"
#include "lang/builtins/formula_calls.hpp"
#include "renderer/functions/apply.hpp"

#include <algorithm>
#include <cmath>

namespace rt::lang::builtins {
namespace {

/// `f` applied to a number, or to each component of a vector.
template <auto f>
Value each(BuiltinCall& c) {
  if (c[0].is_number()) return f(c.number(0));
  const Vec3& v = c.vector(0);
  if (c[0].vector_size() == 2) return Value::point(f(v.x), f(v.y));
  return Vec3{f(v.x), f(v.y), f(v.z)};
}

double sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : x;
}
Term sign_term(const Term& x) {
  const Term zero = x.of(0);
  return select(is_less(zero, x), x.of(1), select(is_less(x, zero), x.of(-1), x));
}

Term trunc_term(const Term& x) {
  return select(is_less(x, x.of(0)), x.apply(Opcode::ceil), x.apply(Opcode::floor));
}

Value sine(BuiltinCall& c) {
  return sin_degrees(c.number(0));
}
Value cosine(BuiltinCall& c) {
  return cos_degrees(c.number(0));
}
Value tangent(BuiltinCall& c) {
  return tan_degrees(c.number(0));
}

/// The angle with this sine or cosine.
template <auto f>
Value arc(BuiltinCall& c) {
  const double sine = as_sine(c.number(0));
  if (std::isnan(sine) && !std::isnan(c.number(0)))
    return c.fail(0, "no angle has this sine or cosine: it must be from -1 to 1",
                  "this is " + format_number(c.number(0)));
  return f(sine);
}

Value arc_tangent(BuiltinCall& c) {
  return atan_degrees(c.number(0));
}
Value arc_tangent2(BuiltinCall& c) {
  return atan2_degrees(c.number(0), c.number(1));
}

Value square_root(BuiltinCall& c) {
  const double x = c.number(0);
  if (x < 0) return c.fail(0, "a negative number has no square root", "this is " + format_number(x));
  return std::sqrt(x);
}

template <auto f>
Value logarithm(BuiltinCall& c) {
  const double x = c.number(0);
  if (x <= 0) return c.fail(0, "only a number greater than 0 has a logarithm", "this is " + format_number(x));
  return f(x);
}

Value exponential(BuiltinCall& c) {
  return std::exp(c.number(0));
}
Value power(BuiltinCall& c) {
  return std::pow(c.number(0), c.number(1));
}
Value modulo(BuiltinCall& c) {
  const double a = c.number(0), b = c.number(1);
  return a - b * std::floor(a / b);
}

Value hypotenuse(BuiltinCall& c) {
  double sum = 0;
  for (std::size_t i = 0; i < c.arguments.size(); ++i) sum = std::hypot(sum, c.number(i));
  return sum;
}

Value hypotenuse_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  Term sum = c.formulas.constant(0);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) sum = sum.apply(Opcode::hypotenuse, c.number(i));
  return c.formulas.value(sum);
}

Value clamped(BuiltinCall& c) {
  const double low = c.number_or(1, 0), high = c.number_or(2, 1);
  if (low > high) return c.fail(1, "the lower bound is above the upper one");
  return std::clamp(c.number(0), low, high);
}

Value clamped_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  return c.formulas.value(clamp(c.number(0), c.number_or(1, 0), c.number_or(2, 1)));
}

Value smooth_step(BuiltinCall& c) {
  const double low = c.number(0), high = c.number(1), x = c.number(2);
  if (low == high) return x < low ? 0.0 : 1.0;
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}
Value smooth_step_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  const Term low = c.number(0), high = c.number(1), x = c.number(2), zero = x.of(0), one = x.of(1);
  const Term t = clamp((x - low) / (high - low), zero, one);
  return c.formulas.value(select(is_equal(low, high), select(is_less(x, low), zero, one), t * t * (3 - 2 * t)));
}

} // namespace

std::span<const Builtin> maths() {
  static constexpr Builtin table[] = {
      {"sin", "angle: number", "sine of an angle in degrees", sine, formula_of<Opcode::sine>},
      {"cos", "angle: number", "cosine of an angle in degrees", cosine, formula_of<Opcode::cosine>},
      {"tan", "angle: number", "tangent of an angle in degrees", tangent, formula_of<Opcode::tangent>},
      {"asin", "x: number", "the angle from -90 to 90 degrees with this sine", arc<asin_degrees>,
       formula_of<Opcode::arc_sine>},
      {"acos", "x: number", "the angle from 0 to 180 degrees with this cosine", arc<acos_degrees>,
       formula_of<Opcode::arc_cosine>},
      {"atan", "x: number", "the angle from -90 to 90 degrees with this tangent", arc_tangent,
       formula_of<Opcode::arc_tangent>},
      {"atan2", "y: number, x: number", "the angle of the point (x, y) from -180 to 180 degrees", arc_tangent2,
       formula_of<Opcode::arc_tangent2>},
      {"sqrt", "x: number", "square root", square_root, formula_of<Opcode::square_root>},
      {"abs", "x: number or point", "absolute value; of a vector component by component",
       each<[](double v) { return std::abs(v); }>, formula_of_each<term_of<Opcode::absolute>>},
      {"sign", "x: number or point", "-1, 0 or 1", each<sign_of>, formula_of_each<sign_term>},
      {"floor", "x: number or point", "the greatest integer not above x", each<[](double v) { return std::floor(v); }>,
       formula_of_each<term_of<Opcode::floor>>},
      {"ceil", "x: number or point", "the least integer not below x", each<[](double v) { return std::ceil(v); }>,
       formula_of_each<term_of<Opcode::ceil>>},
      {"round", "x: number or point", "the nearest integer; halves away from 0",
       each<[](double v) { return std::round(v); }>, formula_of_each<term_of<Opcode::round>>},
      {"trunc", "x: number or point", "the whole part, towards 0", each<[](double v) { return std::trunc(v); }>,
       formula_of_each<trunc_term>},
      {"clamp", "x: number, low: number = 0, high: number = 1", "x clamped between two bounds", clamped,
       clamped_formula},
      {"smoothstep", "low: number, high: number, x: number", "0 below low, 1 above high, an S-curve between",
       smooth_step, smooth_step_formula},
      {"pow", "base: number, exponent: number", "base ^ exponent", power, formula_of<Opcode::power>},
      {"exp", "x: number", "e ^ x", exponential, formula_of<Opcode::exponential>},
      {"log", "x: number", "natural logarithm", logarithm<[](double v) { return std::log(v); }>,
       formula_of<Opcode::logarithm>},
      {"log2", "x: number", "logarithm to base 2", logarithm<[](double v) { return std::log2(v); }>,
       formula_of<Opcode::logarithm2>},
      {"log10", "x: number", "logarithm to base 10", logarithm<[](double v) { return std::log10(v); }>,
       formula_of<Opcode::logarithm10>},
      {"hypot", "x…: number", "square root of the sum of the squares", hypotenuse, hypotenuse_formula},
      {"mod", "a: number, b: number", "a % b: the remainder, with the sign of b", modulo, formula_of<Opcode::modulo>},
  };
  return table;
}

} // namespace rt::lang::builtins
