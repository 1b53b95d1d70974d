#include "renderer/shading/absorption.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

TEST_CASE("absorption: colour^(t/distance) is left, to 13 digits") {
  for (const double left : {1e-9, 0.003, 0.2, 0.5, 0.7071, 0.99, 1 - 1e-12, 1.0}) {
    const Absorption absorption(scene::Absorb{{left, 0.5, 1}, 2.5});
    for (const double length : {0.0, 1e-6, 0.4, 2.5, 9.0}) {
      INFO(left << " after " << length);
      const long double expected = std::pow(static_cast<long double>(left), static_cast<long double>(length) / 2.5L);
      CHECK(absorption.left_after(length).r == Approx(static_cast<double>(expected)).epsilon(1e-12));
      CHECK(absorption.left_after(length).b == 1);
    }
  }
}

TEST_CASE("absorption: what is black or endless leaves nothing, what is clear all") {
  const Absorption black_ink(scene::Absorb{black, 1});
  CHECK(black_ink.left_after(1).g < 1e-299);
  CHECK(black_ink.left_after(2).g == 0);
  CHECK(black_ink.left_after(1e300).g == 0);
  CHECK_FALSE(black_ink.is_clear());
  CHECK(Absorption().is_clear());
  CHECK(Absorption(scene::Absorb{white, 1}).is_clear());
  CHECK(Absorption().left_after(1e300) == white);
}

TEST_CASE("absorption: the natural logarithm is right to a few units in the last place") {
  for (double x = 1e-300; x < 1e300; x *= 1.37e3) {
    const long double expected = std::log(static_cast<long double>(x));
    CHECK(std::abs(natural_logarithm(x) - expected) <= 4e-16L * std::max(1.0L, std::abs(expected)));
  }
}
