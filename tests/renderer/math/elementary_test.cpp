#include "renderer/math/elementary.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace rt;

TEST_CASE("elementary: sine, cosine, arc cosine and decay agree with the C library's") {
  for (int i = -1000; i <= 1000; ++i) {
    const double x = i / 1000.0, angle = x * std::numbers::pi / 4;
    CHECK(std::abs(sine_cosine_near_zero(angle).sine - std::sin(angle)) < 3e-16);
    CHECK(std::abs(sine_cosine_near_zero(angle).cosine - std::cos(angle)) < 3e-16);
    CHECK(std::abs(arc_cosine(x) - std::acos(x)) < 1e-15);
  }
  for (int i = 0; i <= 1000; ++i) {
    const double turns = i / 1000.0;
    CHECK(std::abs(sine_cosine_of_turns(turns).sine - std::sin(2 * std::numbers::pi * turns)) < 1e-15);
    CHECK(std::abs(sine_cosine_of_turns(turns).cosine - std::cos(2 * std::numbers::pi * turns)) < 1e-15);
    CHECK(exponential_decay(turns * 50) == Approx(std::exp(-turns * 50)).epsilon(1e-12));
  }
}
