#pragma once

#include <algorithm>

namespace rt {

/// A colour: linear RGB with sRGB's primaries, 1 is full white, unbounded above.
struct Color {
  double r = 0, g = 0, b = 0;

  friend constexpr bool operator==(const Color&, const Color&) = default;
  constexpr Color& operator+=(const Color& c) {
    r += c.r, g += c.g, b += c.b;
    return *this;
  }
  constexpr Color& operator*=(const Color& c) {
    r *= c.r, g *= c.g, b *= c.b;
    return *this;
  }
};

inline constexpr Color black{0, 0, 0};
inline constexpr Color white{1, 1, 1};

constexpr Color grey(double v) {
  return {v, v, v};
}
constexpr Color operator+(const Color& a, const Color& b) {
  return {a.r + b.r, a.g + b.g, a.b + b.b};
}
constexpr Color operator-(const Color& a, const Color& b) {
  return {a.r - b.r, a.g - b.g, a.b - b.b};
}
constexpr Color operator*(const Color& a, const Color& b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
constexpr Color operator*(const Color& a, double s) {
  return {a.r * s, a.g * s, a.b * s};
}
constexpr Color operator*(double s, const Color& a) {
  return a * s;
}
constexpr double max_component(const Color& c) {
  return std::max({c.r, c.g, c.b});
}

/// sRGB's transfer function (IEC 61966-2-1), odd-symmetric below zero: encoded value to linear light and back.
double srgb_to_linear(double encoded);
double linear_to_srgb(double linear);

} // namespace rt
