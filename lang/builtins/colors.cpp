#include "lang/builtins/builtins.hpp"
#include "lang/builtins/formula_calls.hpp"
#include "lang/values/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang::builtins {
namespace {

Color from_srgb(double r, double g, double b) {
  return {srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b)};
}

Value srgb_color(BuiltinCall& c) {
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = c.number(i);
    if (x >= 0 && x <= 1) continue;
    const bool is_byte = x > 1 && x <= 255 && x == std::floor(x);
    return c.fail(i, "rgb takes numbers from 0 to 1",
                  is_byte ? fmt::format("write `{:.0f} / 255`, or the whole colour as `#rrggbb`", x)
                  : x > 1 ? "light that is brighter than white is `linear_rgb(r, g, b)`"
                          : fmt::format("this is {}", x));
  }
  return from_srgb(c.number(0), c.number(1), c.number(2));
}
Value linear_color(BuiltinCall& c) {
  return Color{c.number(0), c.number(1), c.number(2)};
}

// Each channel is a trapezoid over the hue, a third of the circle apart: A. R. Smith, Color Gamut Transform Pairs,
// 1978.
Value hsv_color(BuiltinCall& c) {
  const double hue = c.number(0), saturation = c.number(1), value = c.number(2);
  const auto channel = [&](double shift) {
    const double sixth = shift + hue / 60, k = sixth - 6 * std::floor(sixth / 6);
    return value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  return from_srgb(channel(5), channel(3), channel(1));
}

Value mixed(BuiltinCall& c) {
  const double t = c.number(2);
  const Value &a = c[0], &b = c[1];
  if (a.is_number() && b.is_number()) return a.number() + (b.number() - a.number()) * t;
  if (a.is(ValueKind::vector) && b.is(ValueKind::vector)) {
    if (a.vector_size() != b.vector_size()) return c.fail(1, "both vectors must have the same number of components");
    const Vec3 v = a.vector() + (b.vector() - a.vector()) * t;
    return a.vector_size() == 2 ? Value::point(v.x, v.y) : Value(v);
  }
  const auto first = as_color(a), second = as_color(b);
  if (!first || !second)
    return c.fail(1, "mix takes two numbers, two vectors or two colours", "this is " + describe(b));
  return *first + (*second - *first) * t;
}

// The same where a number depends on the point.

Term linear_term(const Term& encoded) {
  const Term size = abs(encoded);
  const Term curve = ((size + 0.055) / 1.055).apply(Opcode::power, 2.4);
  const Term linear = select(size.apply(Opcode::less_equal, 0.04045), size / 12.92, curve);
  return select(is_less(encoded, encoded.of(0)), -linear, linear);
}

/// Numbers beyond 0 and 1, which are a mistake where they are known, are held between them.
Value srgb_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  const Term zero = c.formulas.constant(0), one = c.formulas.constant(1);
  const auto channel = [&](std::size_t i) { return linear_term(clamp(c.number(i), zero, one)); };
  return c.formulas.color({channel(0), channel(1), channel(2)});
}
Value linear_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  return c.formulas.color({c.number(0), c.number(1), c.number(2)});
}

Value hsv_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  const Term hue = c.number(0), saturation = c.number(1), value = c.number(2), zero = hue.of(0), one = hue.of(1);
  const auto channel = [&](double shift) {
    const Term sixth = shift + hue / 60, k = sixth - 6 * (sixth / 6).apply(Opcode::floor);
    const Term share = clamp(k.apply(Opcode::minimum, 4 - k), zero, one);
    return linear_term(value - value * saturation * share);
  };
  return c.formulas.color({channel(5), channel(3), channel(1)});
}

Value mixed_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  const Formulas& f = c.formulas;
  const Term t = c.number(2);
  const auto mix = [&](const TermVector& a, const TermVector& b) {
    return TermVector{a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
  };
  if (is_number_like(call[0]) && is_number_like(call[1])) return f.value(c.number(0) + (c.number(1) - c.number(0)) * t);
  const std::size_t size = vector_like_size(call[0]);
  if (size > 0 && size == vector_like_size(call[1])) return f.vector(mix(c.vector(0), c.vector(1)), size);
  const auto a = f.color(call[0]), b = f.color(call[1]);
  if (a && b) return f.color(mix(*a, *b));
  return call.fail(1, "mix takes two numbers, two vectors or two colours", "this is " + describe(call[1]));
}

} // namespace

std::span<const Builtin> colors() {
  static constexpr Builtin table[] = {
      {"rgb", "r: number, g: number, b: number", "colour from sRGB values, 0 to 1", srgb_color, srgb_formula},
      {"linear_rgb", "r: number, g: number, b: number", "colour from linear light, 0 to 1 and beyond", linear_color,
       linear_formula},
      {"hsv", "hue: number, saturation: number, value: number",
       "colour from hue in degrees, saturation and value from 0 to 1 (sRGB)", hsv_color, hsv_formula},
      {"mix", "a: number or point or color, b: number or point or color, t: number", "a + t (b - a): a at 0, b at 1",
       mixed, mixed_formula},
      {"lerp", "a: number or point or color, b: number or point or color, t: number", "another name for mix", mixed,
       mixed_formula},
  };
  return table;
}

} // namespace rt::lang::builtins
