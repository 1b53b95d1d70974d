#include "renderer/patterns/graded/graded.hpp"

#include "renderer/math/degrees.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

// From and to between 0 and 1.
double waved(scene::Wave wave, double x) {
  switch (wave) {
  case scene::Wave::ramp:
    return x;
  case scene::Wave::triangle:
    return x < 0.5 ? 2 * x : 2 * (1 - x);
  case scene::Wave::sine:
    return (1 + sin_degrees(360 * x)) / 2;
  case scene::Wave::scallop:
    return std::abs(sin_degrees(180 * x));
  case scene::Wave::cubic:
    return x * x * (3 - 2 * x);
  }
  return x;
}

} // namespace

double within_period(double x) {
  if (x > 1) return x - std::ceil(x) + 1;
  return x < 0 ? x - std::floor(x) : x;
}

double place_in_stops(const scene::Graded& pattern, double value) {
  const double place = waved(pattern.wave, within_period(value * pattern.frequency + pattern.phase));
  return pattern.exponent == 1 ? place : std::pow(place, pattern.exponent);
}

PaintBlend blend_at(const scene::Graded& pattern, double place) {
  const auto next = std::ranges::upper_bound(pattern.stops, place, {}, &scene::Stop::place);
  if (next == pattern.stops.begin()) return {next->shown, next->shown};
  const scene::Stop& stop = *(next - 1);
  if (pattern.stepped || next == pattern.stops.end()) return {stop.shown, stop.shown};
  return {stop.shown, next->shown, (place - stop.place) / (next->place - stop.place)};
}

} // namespace rt
