#include "renderer/math/degrees.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

TEST_CASE("degrees: what is 0, ½ or 1 is exact in every quadrant") {
  const double h = 0.5;
  const double angles[] = {0, 30, 90, 150, 180, 210, 270, 330, 360};
  const double sines[] = {0, h, 1, h, 0, -h, -1, -h, 0};
  for (int i = 0; i <= 8; ++i) {
    INFO(angles[i]);
    CHECK(sin_degrees(angles[i]) == sines[i]);
    CHECK(sin_degrees(-angles[i]) == -sines[i]);
    CHECK(sin_degrees(angles[i] + 7200) == sines[i]);
    CHECK(cos_degrees(angles[i] - 90) == sines[i]);
    CHECK(cos_degrees(90 - angles[i]) == sines[i]);
  }
}

TEST_CASE("degrees: arcs of what is known exactly are whole numbers") {
  CHECK(asin_degrees(0.5) == 30);
  CHECK(asin_degrees(std::sqrt(3.0) / 2) == 60);
  CHECK(acos_degrees(0.5) == 60);
  CHECK(acos_degrees(-0.5) == 120);
  CHECK(acos_degrees(0) == 90);
  CHECK(atan_degrees(1) == 45);
  CHECK(atan_degrees(std::sqrt(3.0)) == 60);
  CHECK(atan_degrees(INFINITY) == 90);
  CHECK(atan2_degrees(0, -1) == 180);
  CHECK(atan2_degrees(-2, -2) == -135);
  for (int a = -90; a <= 90; ++a) {
    CHECK(asin_degrees(sin_degrees(a)) == a);
    CHECK(acos_degrees(cos_degrees(a + 90)) == a + 90);
  }
}

TEST_CASE("degrees: other angles are the library's, in radians") {
  for (const double a : {1e-9, 0.1, 44.999999, 45.000001, 89.5, 90.5, 179, 200.25, 300.1}) {
    const double radians = a * std::acos(-1.0) / 180;
    CHECK(sin_degrees(a) == Approx(std::sin(radians)).epsilon(1e-14));
    CHECK(cos_degrees(a) == Approx(std::cos(radians)).epsilon(1e-14));
  }
  CHECK(asin_degrees(0.3) == Approx(17.457603123722092).epsilon(1e-15));
  CHECK(std::isnan(sin_degrees(NAN)));
  CHECK(std::isnan(sin_degrees(INFINITY)));
}
