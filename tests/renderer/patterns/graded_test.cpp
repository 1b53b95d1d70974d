#include "renderer/patterns/graded/cells.hpp"
#include "renderer/patterns/graded/gradient.hpp"
#include "renderer/patterns/graded/leopard.hpp"
#include "renderer/patterns/graded/onion.hpp"
#include "renderer/patterns/graded/rings.hpp"
#include "renderer/patterns/graded/spiral.hpp"

#include <catch2/catch.hpp>

#include <numbers>
#include <set>

using namespace rt;
using scene::Gradient;
using scene::Wave;

namespace {

scene::Graded with(const scene::Stops& stops) {
  scene::Graded pattern;
  pattern.stops = stops;
  return pattern;
}
scene::Graded waving(Wave wave) {
  scene::Graded pattern;
  pattern.wave = wave;
  return pattern;
}
Gradient of(Gradient::Kind kind) {
  Gradient gradient;
  gradient.kind = kind;
  return gradient;
}
double grey_at(const scene::Graded& pattern, double place) {
  const PaintBlend blend = blend_at(pattern, place);
  return std::get<Color>(blend.first).g * (1 - blend.share) + std::get<Color>(blend.second).g * blend.share;
}

} // namespace

TEST_CASE("graded: a period ends with 1, and what is beyond begins anew") {
  CHECK(within_period(0) == 0);
  CHECK(within_period(0.25) == 0.25);
  CHECK(within_period(1) == 1);
  CHECK(within_period(1.25) == 0.25);
  CHECK(within_period(3) == 1);
  CHECK(within_period(-0.25) == 0.75);
  CHECK(within_period(-2) == 0);
}

TEST_CASE("graded: wave forms at the quarters of a period") {
  const auto quarters = [](Wave wave) {
    std::vector<double> values;
    for (const double x : {0.0, 0.25, 0.5, 0.75, 1.0}) values.push_back(place_in_stops(waving(wave), x));
    return values;
  };
  const auto are = [](const std::vector<double>& values, std::initializer_list<double> expected) {
    CHECK_THAT(values, Catch::Approx(std::vector<double>(expected)).margin(1e-15));
  };
  are(quarters(Wave::ramp), {0, 0.25, 0.5, 0.75, 1});
  are(quarters(Wave::triangle), {0, 0.5, 1, 0.5, 0});
  are(quarters(Wave::sine), {0.5, 1, 0.5, 0, 0.5});                                          // (1 + sin 2πx)/2
  are(quarters(Wave::scallop), {0, std::numbers::sqrt2 / 2, 1, std::numbers::sqrt2 / 2, 0}); // |sin πx|
  are(quarters(Wave::cubic), {0, 0.15625, 0.5, 0.84375, 1});                                 // 3x² − 2x³
}

TEST_CASE("graded: frequency and phase come before the wave form, the exponent after it") {
  scene::Graded pattern;
  pattern.frequency = 3, pattern.phase = 0.25;
  CHECK(place_in_stops(pattern, 0.5) == Approx(0.75)); // 1.75
  pattern.frequency = -1, pattern.phase = 0;
  CHECK(place_in_stops(pattern, 0.25) == Approx(0.75));
  pattern = waving(Wave::triangle);
  pattern.exponent = 3;
  CHECK(place_in_stops(pattern, 0.25) == Approx(0.125));
}

TEST_CASE("graded: stops show themselves, between two a mixture in linear light, beyond them the last one") {
  const scene::Graded pattern = with({{0.2, grey(0.5)}, {0.4, grey(1)}, {0.8, grey(3)}});
  CHECK(grey_at(pattern, 0) == 0.5);
  CHECK(grey_at(pattern, 0.2) == 0.5);
  CHECK(grey_at(pattern, 0.3) == Approx(0.75));
  CHECK(grey_at(pattern, 0.7) == Approx(2.5));
  CHECK(grey_at(pattern, 0.8) == 3);
  CHECK(grey_at(pattern, 1) == 3);
}

TEST_CASE("graded: two stops in one place are an edge; stepped ones have nothing else") {
  const scene::Graded edge = with({{0, grey(1)}, {0.5, grey(2)}, {0.5, grey(5)}, {1, grey(6)}});
  CHECK(grey_at(edge, 0.499999) == Approx(2).epsilon(1e-5));
  CHECK(grey_at(edge, 0.5) == 5);
  scene::Graded stepped = with({{0.2, grey(1)}, {0.6, grey(2)}});
  stepped.stepped = true;
  CHECK(grey_at(stepped, 0.1) == 1);
  CHECK(grey_at(stepped, 0.59) == 1);
  CHECK(grey_at(stepped, 0.6) == 2);
  CHECK(grey_at(with({{0.5, grey(7)}}), 0.1) == 7);
}

TEST_CASE("gradient: along a direction of any length, repeated or held") {
  Gradient gradient;
  gradient.direction = {3, 0, 4};
  CHECK(value_at(gradient, {0.5, 9, 0.5}) == Approx(0.7)); // (3 + 4)/5 · 0.5
  CHECK(value_at(gradient, {-0.5, 9, -0.5}) == Approx(0.3));
  CHECK(value_at(gradient, {1, 9, 1}) == Approx(0.4));
  gradient.repeat = false;
  CHECK(value_at(gradient, {-0.5, 9, -0.5}) == 0);
  CHECK(value_at(gradient, {1, 9, 1}) == 1);
}

TEST_CASE("gradient: about the y axis in turns, and by the angle from it in half turns") {
  const Gradient radial = of(Gradient::Kind::radial), angular = of(Gradient::Kind::angular);
  CHECK(value_at(radial, {2, 5, 0}) == 0);
  CHECK(value_at(radial, {0, 5, -2}) == Approx(0.25));
  CHECK(value_at(radial, {-2, 5, 0}) == Approx(0.5));
  CHECK(value_at(radial, {0, 5, 2}) == Approx(0.75));
  CHECK(value_at(angular, {0, 3, 0}) == 0);
  CHECK(value_at(angular, {1, 1, 0}) == Approx(0.25));
  CHECK(value_at(angular, {0, 0, -3}) == Approx(0.5));
  CHECK(value_at(angular, {0, -3, 0}) == 1);
}

TEST_CASE("gradient: from the middle it falls to 0 within one unit") {
  const Vec3 p{0.3, 0.2, 0.4};
  CHECK(value_at(of(Gradient::Kind::spherical), p) == Approx(1 - 0.538516)); // √0.29
  CHECK(value_at(of(Gradient::Kind::cylindrical), p) == Approx(0.5));
  CHECK(value_at(of(Gradient::Kind::box), p) == Approx(0.6));
  for (const auto kind : {Gradient::Kind::spherical, Gradient::Kind::cylindrical, Gradient::Kind::box}) {
    CHECK(value_at(of(kind), {0, 0, 0}) == 1);
    CHECK(value_at(of(kind), {-1.5, 2, 0.1}) == 0);
  }
}

TEST_CASE("onion and rings: the distance from the middle, or the y axis, less whole units") {
  CHECK(value_at(scene::Onion{}, {2, 3, 6}) == 0); // 7
  CHECK(value_at(scene::Onion{}, {0, -1.25, 0}) == Approx(0.25));
  CHECK(value_at(scene::Rings{}, {3, 99, 4}) == 0); // 5
  CHECK(value_at(scene::Rings{}, {0, -7, -2.75}) == Approx(0.75));
}

TEST_CASE("leopard: spots where the three sines agree") {
  const double quarter = std::numbers::pi / 2;
  CHECK(value_at(scene::Leopard{}, {quarter, quarter, quarter}) == Approx(1));
  CHECK(value_at(scene::Leopard{}, {-quarter, -quarter, 3 * quarter}) == Approx(1));
  CHECK(value_at(scene::Leopard{}, {quarter, 0, 0}) == Approx(1.0 / 9));
  CHECK(value_at(scene::Leopard{}, {0, 0, 0}) == 0);
}

TEST_CASE("spiral: each arm goes once through the stops in one unit, or one turn") {
  scene::Spiral spiral;
  CHECK(value_at(spiral, {0.25, 5, 0}) == Approx(0.25));
  CHECK(value_at(spiral, {0, 5, -0.25}) == Approx(0.5));
  spiral.arms = 3;
  CHECK(value_at(spiral, {0, 5, -0.5}) == Approx(0.25)); // 0.75 + 0.5
  spiral.arms = -1;
  CHECK(value_at(spiral, {0, 5, -0.5}) == Approx(0.25)); // −0.25 + 0.5
}

TEST_CASE("cells: one value a cube, evenly spread, others with another seed") {
  const scene::Cells cells;
  scene::Cells other;
  other.seed = 1;
  CHECK(value_at(cells, {0.1, 0.9, 0.5}) == value_at(cells, {0.99, 0, 0.01}));
  std::set<double> values;
  double sum = 0, squares = 0;
  const int n = 20;
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 p{i % n - 9.5, i / n % n - 9.5, i / n / n - 9.5};
    const double value = value_at(cells, p);
    CHECK((value >= 0 && value < 1));
    values.insert(value);
    sum += value, squares += value * value;
    if (i < 10) CHECK(value != value_at(other, p));
  }
  CHECK(values.size() == 8000);
  // Of 8000 even numbers the mean is ½ ± 0.0032 and that of the squares ⅓ ± 0.0033: within four times that.
  CHECK(sum / 8000 == Approx(0.5).margin(0.013));
  CHECK(squares / 8000 == Approx(1.0 / 3).margin(0.0134));
}
