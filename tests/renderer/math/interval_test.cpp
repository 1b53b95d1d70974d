#include "renderer/math/interval.hpp"

#include <catch2/catch.hpp>

using namespace rt;

TEST_CASE("intervals: open below, closed above, and never endless") {
  const Interval range{1, 2};
  CHECK_FALSE(range.contains(1));
  CHECK(range.contains(2));
  CHECK_FALSE(range.contains(2.5));
  CHECK_FALSE(Interval{}.contains(0));
  CHECK(Interval{}.contains(1e300));
  CHECK_FALSE(Interval{}.contains(std::numeric_limits<double>::infinity()));
  CHECK_FALSE(Interval{}.contains(std::numeric_limits<double>::quiet_NaN()));
}
