#include "renderer/lighting/light_tree.hpp"
#include "renderer/math/random.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace rt;

namespace {

// Half of them flat, half shining all around.
std::vector<LightBounds> street(int count, double unit = 1) {
  SplitMix64 random(5);
  std::vector<LightBounds> lamps;
  for (int i = 0; i < count; ++i) {
    const auto between = [&](double a, double b) { return random.between(a, b); };
    LightBounds lamp;
    lamp.center = Vec3{between(-50, 50), between(0, 9), between(-4, 4)} * unit;
    lamp.radius = between(0.01, 0.2) * unit;
    lamp.power = between(0.5, 2);
    lamp.axis = normalize(Vec3{between(-1, 1), between(-1, 1), between(-1, 1)});
    lamp.cos_spread = i % 2 == 0 ? 1 : 0;
    lamps.push_back(lamp);
  }
  return lamps;
}

} // namespace

TEST_CASE("light tree: the probabilities of all lamps make 1, and a choice says its own") {
  for (const int count : {1, 2, 3, 1000}) {
    const LightTree tree(street(count));
    SplitMix64 random(9);
    for (int k = 0; k < 20; ++k) {
      const Vec3 p{random.between(-60, 60), random.between(-1, 10), random.between(-9, 9)};
      double sum = 0;
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) sum += tree.probability(i, p);
      CHECK(sum == Approx(1).epsilon(1e-12));
      const LightTree::Choice choice = tree.choose(p, random.between(0, 1));
      CHECK(choice.probability == tree.probability(choice.index, p));
      CHECK(choice.probability > 0);
    }
  }
}

// Chi-squared against the probabilities themselves, cells of fewer than 5 pooled: the quantile of 99.9 % is about
// n + 3.1·√(2n) + 6.
TEST_CASE("light tree: lamps are picked as often as it says") {
  const LightTree tree(street(64));
  const Vec3 p{3, 1, 2};
  constexpr int draws = 200'000;
  std::vector<int> found(64);
  SplitMix64 random(1);
  for (int i = 0; i < draws; ++i) ++found[tree.choose(p, random.between(0, 1)).index];
  double statistic = 0, rest_expected = 0, rest_found = 0;
  int cells = 0;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const double expected = draws * tree.probability(i, p);
    if (expected < 5) {
      rest_expected += expected, rest_found += found[i];
      continue;
    }
    statistic += std::pow(found[i] - expected, 2) / expected;
    ++cells;
  }
  if (rest_expected > 5) statistic += std::pow(rest_found - rest_expected, 2) / rest_expected, ++cells;
  CHECK(cells > 8);
  CHECK(statistic < cells + 3.1 * std::sqrt(2.0 * cells) + 6);
}

TEST_CASE("light tree: a scene a thousand times as large makes the same choices") {
  const LightTree small(street(500)), large(street(500, 1000));
  SplitMix64 random(3);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 p{random.between(-60, 60), random.between(-1, 10), random.between(-9, 9)};
    const double u = random.between(0, 1);
    const LightTree::Choice a = small.choose(p, u), b = large.choose(p * 1000, u);
    CHECK(a.index == b.index);
    CHECK(a.probability == Approx(b.probability).epsilon(1e-9));
  }
}

// Nothing that a lamp gives to a point may get lost, however its node is bounded: a node's importance is 0 only where
// those of all its lamps are, whose true cosines may be greater but not smaller.
TEST_CASE("light tree: bounds hold what they unite") {
  const std::vector<LightBounds> lamps = street(200);
  LightBounds all = lamps[0];
  for (const LightBounds& lamp : lamps) all = united(all, lamp);
  for (const LightBounds& lamp : lamps) {
    CHECK(length(lamp.center - all.center) + lamp.radius <= all.radius * (1 + 1e-12));
    for (const LightBounds& other : lamps) {
      const LightBounds two = united(lamp, other);
      CHECK(length(other.center - two.center) + other.radius <= two.radius * (1 + 1e-9));
      CHECK(std::abs(dot(two.axis, lamp.axis)) >= two.cos_spread - 1e-9);
      CHECK(two.power == lamp.power + other.power);
    }
  }
  // Flat, seen edge-on it gives nothing, and seen from the front power/d².
  const LightBounds flat{{0, 0, 0}, 1e-9, 3, {0, 1, 0}, 1};
  CHECK(importance(flat, {0, 2, 0}) == Approx(0.75));
  CHECK(importance(flat, {2, 0, 0}) < 1e-8);
  CHECK(importance(flat, {0, -2, 0}) == Approx(0.75));
}
