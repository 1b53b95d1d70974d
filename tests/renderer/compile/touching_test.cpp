#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

TEST_CASE("touching: a hit is contested by what is within rounding of it, and by nothing else") {
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, 0)), k.add(k.sphere(1)), k.add(k.box({3, 0, -1}, {5, 1, 1}));
  const Vec3 down{0, -1, 0};
  Asked asked(k);
  CHECK_FALSE(asked.nearest({0, 5, 0}, down).is_contested);
  CHECK_FALSE(asked.nearest({4, 5, 0}, down).is_contested);
  CHECK(asked.nearest({4, -5, 0}, {0, 1, 0}).is_contested);
}
