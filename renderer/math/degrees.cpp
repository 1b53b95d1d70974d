#include "renderer/math/degrees.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace rt {

namespace {

constexpr double per_radian = 180 / std::numbers::pi;

// The sine of a multiple of 30° or 45°, correctly rounded, for a from 0 to 90.
std::optional<double> set_square_sine(double a) {
  if (a == 0) return 0;
  if (a == 30) return 0.5;
  if (a == 45) return std::sqrt(0.5);
  if (a == 60) return std::sqrt(0.75);
  if (a == 90) return 1;
  return std::nullopt;
}

// If rounding has moved an arc off a whole number of degrees it is moved back: `f` of that number is the same double.
template <typename F>
double whole_if_same(double degrees, double value, F f) {
  const double whole = std::round(degrees);
  return f(whole) == value ? whole : degrees;
}

} // namespace

double sin_degrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0); // exact, like the differences below
  const double a = std::abs(turn);
  const double half = a >= 180 ? a - 180 : a;
  if (const auto exact = set_square_sine(half > 90 ? 180 - half : half))
    return *exact == 0 ? 0 : std::signbit(turn) != (a >= 180) ? -*exact : *exact;
  return std::sin(turn * (std::numbers::pi / 180));
}

double cos_degrees(double degrees) {
  const double turn = std::abs(std::fmod(degrees, 360.0));
  const double a = turn > 180 ? 360 - turn : turn;
  if (const auto exact = set_square_sine(std::abs(90 - a))) return a > 90 ? -*exact : *exact;
  return std::cos(turn * (std::numbers::pi / 180));
}

double tan_degrees(double degrees) {
  return sin_degrees(degrees) / cos_degrees(degrees);
}

double asin_degrees(double x) {
  return whole_if_same(std::asin(x) * per_radian, x, sin_degrees);
}

double acos_degrees(double x) {
  return whole_if_same(std::acos(x) * per_radian, x, cos_degrees);
}

double atan_degrees(double x) {
  return whole_if_same(std::atan(x) * per_radian, x, tan_degrees);
}

double atan2_degrees(double y, double x) {
  return whole_if_same(std::atan2(y, x) * per_radian, y / x, tan_degrees);
}

} // namespace rt
