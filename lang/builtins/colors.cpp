#include "lang/builtins/builtins.hpp"
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
    double k = std::fmod(shift + hue / 60, 6);
    if (k < 0) k += 6;
    return value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  return from_srgb(channel(5), channel(3), channel(1));
}

Value mixed(BuiltinCall& c) {
  const double t = c.number(2);
  const Value &a = c[0], &b = c[1];
  if (a.is_number() && b.is_number()) return a.number() + (b.number() - a.number()) * t;
  if (a.is(ValueKind::vector) && b.is(ValueKind::vector)) {
    if (a.vector_size() != b.vector_size()) return c.fail(1, "both vectors must have as many numbers");
    const Vec3 v = a.vector() + (b.vector() - a.vector()) * t;
    return a.vector_size() == 2 ? Value::point(v.x, v.y) : Value(v);
  }
  const auto first = as_color(a), second = as_color(b);
  if (!first || !second)
    return c.fail(1, "mix takes two numbers, two vectors or two colours", "this is " + describe(b));
  return *first + (*second - *first) * t;
}

} // namespace

std::span<const Builtin> colors() {
  static constexpr Builtin table[] = {
      {"rgb", "r: number, g: number, b: number", "colour from sRGB values, 0 to 1", srgb_color},
      {"linear_rgb", "r: number, g: number, b: number", "colour from linear light, 0 to 1 and beyond", linear_color},
      {"hsv", "hue: number, saturation: number, value: number",
       "colour from hue in degrees, saturation and value from 0 to 1 (sRGB)", hsv_color},
      {"mix", "a: number or point or color, b: number or point or color, t: number", "a + t (b - a): a at 0, b at 1",
       mixed},
      {"lerp", "a: number or point or color, b: number or point or color, t: number", "another name for mix", mixed},
  };
  return table;
}

} // namespace rt::lang::builtins
