// Patterns by chance: range, mean, octaves, continuity.

#include "renderer/math/noise.hpp"
#include "renderer/math/random.hpp"
#include "renderer/patterns/chance/agate.hpp"
#include "renderer/patterns/chance/crackle.hpp"
#include "renderer/patterns/chance/granite.hpp"
#include "renderer/patterns/chance/marble.hpp"
#include "renderer/patterns/chance/noise.hpp"
#include "renderer/patterns/chance/ripples.hpp"
#include "renderer/patterns/chance/turbulence.hpp"
#include "renderer/patterns/chance/wood.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace rt;

namespace {

Vec3 point(SplitMix64& random) {
  return {random.between(-50, 50), random.between(-50, 50), random.between(-50, 50)};
}

template <class P>
void check_range_and_continuity(const P& pattern) {
  INFO(std::string(P::noun));
  SplitMix64 random(7);
  double least = 1, most = 0, steepest = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3 p = point(random);
    const double value = value_at(pattern, p);
    least = std::min(least, value), most = std::max(most, value);
    steepest = std::max(steepest, std::abs(value_at(pattern, p + Vec3{1e-7, -1e-7, 1e-7}) - value));
  }
  CHECK(least >= 0);
  CHECK(most <= 1);
  CHECK(most - least > 0.4);
  CHECK(steepest < 1e-4);
}

} // namespace

TEST_CASE("fractal: one octave is the noise itself, and others are finer and weaker, with seeds of their own") {
  scene::Noise one;
  one.octaves = 1, one.seed = 5;
  scene::Noise three = one;
  three.octaves = 3, three.lacunarity = 3, three.gain = 0.25;
  SplitMix64 random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = point(random);
    const auto octave = [&](int k, double scale) {
      return gradient_noise(mixed_seed(mixed_seed(5, 0), static_cast<std::uint64_t>(k)), p * scale);
    };
    CHECK(fractal_noise(one, p) == octave(0, 1));
    CHECK(fractal_noise(three, p) ==
          Approx((octave(0, 1) + 0.25 * octave(1, 3) + 0.0625 * octave(2, 9)) / 1.3125).margin(1e-12));
    CHECK(turbulence(one, p) == std::abs(octave(0, 1)));
    CHECK(value_at(one, p) == Approx((1 + octave(0, 1)) / 2));
  }
}

TEST_CASE("fractal: all values are from 0 to 1, and none jumps") {
  check_range_and_continuity(scene::Noise{});
  check_range_and_continuity(scene::Turbulence{});
  check_range_and_continuity(scene::Granite{});
  check_range_and_continuity(scene::Marble{});
  check_range_and_continuity(scene::Wood{});
  check_range_and_continuity(scene::Agate{});
  check_range_and_continuity(scene::Crackle{});
  check_range_and_continuity(scene::Ripples{});
  scene::Ripples waves;
  waves.spread = 1;
  check_range_and_continuity(waves);
}

TEST_CASE("noise: its mean is one half, and it is the same wherever one looks") {
  // Gradients are as often turned one way as the other, so the mean is ½. Noise a unit apart has next to nothing in
  // common: 30,000 points scatter it by no more than 0.15/√30,000 = 0.0009.
  SplitMix64 random(3);
  double sum = 0;
  for (int i = 0; i < 30'000; ++i) sum += value_at(scene::Noise{}, point(random));
  CHECK(sum / 30'000 == Approx(0.5).margin(4 * 0.0009));
}

TEST_CASE("marble and wood: without wandering and grain they are even") {
  scene::Marble marble;
  marble.wander = 0;
  CHECK(value_at(marble, {3, 0.3, 0.7}) == 1);
  CHECK(value_at(marble, {3.5, 0.3, 0.7}) == 0);
  CHECK(value_at(marble, {3.25, 0.3, 0.7}) == Approx(0.5));
  scene::Wood wood;
  wood.wander = 0, wood.grain = 0;
  CHECK(value_at(wood, {1.4, 0.3, 0}) == Approx(0.5)); // half of the rise, which takes 0.8
  CHECK(value_at(wood, {0, 0.3, 2.9}) == Approx(0.5)); // half of the fall
  CHECK(value_at(wood, {0, 0.3, 2.8}) == Approx(1));
}

TEST_CASE("agate: without wandering, bands 1/1.1 apart") {
  scene::Agate agate;
  agate.wander = 0;
  CHECK(value_at(agate, {7, 0.25 / 1.1, 3}) == Approx(1));
  CHECK(value_at(agate, {7, 0.75 / 1.1, 3}) == Approx(0).margin(1e-9));
  CHECK(value_at(agate, {7, 1 / 1.1, 3}) == Approx(std::pow(0.5, 0.77)));
}

TEST_CASE("crackle: the two nearest of one point a cube, found without looking at all") {
  SplitMix64 random(11);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = point(random);
    const CellDistances here = cell_distances(4, p);
    CHECK(here.first <= here.second);
    // A step of s brings nothing nearer than s.
    const Vec3 q = p + Vec3{0.03, -0.02, 0.06}; // 0.07 away
    const CellDistances there = cell_distances(4, q);
    CHECK(std::abs(there.first - here.first) <= 0.07 + 1e-12);
    CHECK(std::abs(there.second - here.second) <= 0.07 + 1e-12);
  }
  // One point a unit of volume: the nearest is about as far as of points strewn at random, Γ(4/3)/(4π/3)^⅓ = 0.554.
  double sum = 0;
  for (int i = 0; i < 4000; ++i) sum += cell_distances(1, point(random)).first;
  CHECK(sum / 4000 == Approx(0.554).epsilon(0.1));
  scene::Crackle crackle;
  crackle.seed = 4;
  const Vec3 p{0.3, 7.1, -2.2};
  const CellDistances d = cell_distances(4, p);
  CHECK(value_at(crackle, p) == std::min(1.0, d.second - d.first));
  crackle.measure = scene::Crackle::Measure::first;
  CHECK(value_at(crackle, p) == std::min(1.0, d.first));
  crackle.measure = scene::Crackle::Measure::second;
  CHECK(value_at(crackle, p) == std::min(1.0, d.second));
}

TEST_CASE("ripples: from one source, waves of one unit") {
  scene::Ripples ripples;
  ripples.sources = 1;
  // Far away along x the distance grows as x does.
  const Vec3 p{5000, 1, -1};
  const double here = value_at(ripples, p);
  CHECK(value_at(ripples, p + Vec3{1, 0, 0}) == Approx(here).margin(1e-5));
  CHECK(value_at(ripples, p + Vec3{0.5, 0, 0}) == Approx(1 - here).margin(1e-5));
}

TEST_CASE("marble: veins wander no farther than they may") {
  scene::Marble marble;
  marble.wander = 0.25;
  SplitMix64 random(9);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = point(random);
    const double x = p.x - std::floor(p.x); // u is between x and x + ¼, and the value falls or rises by 2 a unit
    if (x > 0 && x < 0.25) CHECK(value_at(marble, {x, p.y, p.z}) >= 1 - 2 * (x + 0.25) - 1e-12);
    if (x > 0.5 && x < 0.75) CHECK(value_at(marble, {x, p.y, p.z}) >= 2 * x - 1 - 1e-12);
  }
}
