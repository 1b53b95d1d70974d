#include "renderer/math/degrees.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

TEST_CASE("degrees: the set square is exact in every quadrant") {
  // Sines of 0, 30, 45, … 360 degrees, by hand; √½ and √¾ are correctly rounded by the machine's square root.
  const double h = 0.5, d = std::sqrt(0.5), t = std::sqrt(0.75);
  const double angles[] = {0, 30, 45, 60, 90, 120, 135, 150, 180, 210, 225, 240, 270, 300, 315, 330, 360};
  const double sines[] = {0, h, d, t, 1, t, d, h, 0, -h, -d, -t, -1, -t, -d, -h, 0};
  for (int i = 0; i <= 16; ++i) {
    INFO(angles[i]);
    CHECK(sin_degrees(angles[i]) == sines[i]);
    CHECK(sin_degrees(-angles[i]) == -sines[i]);
    CHECK(sin_degrees(angles[i] + 7200) == sines[i]);
    CHECK(cos_degrees(angles[i] - 90) == sines[i]);
    CHECK(cos_degrees(90 - angles[i]) == sines[i]);
  }
  CHECK(tan_degrees(45) == 1);
  CHECK(tan_degrees(135) == -1);
  CHECK(tan_degrees(60) == std::sqrt(3.0));
}

TEST_CASE("degrees: arcs of the set square are whole numbers") {
  CHECK(asin_degrees(0.5) == 30);
  CHECK(asin_degrees(-std::sqrt(0.5)) == -45);
  CHECK(asin_degrees(std::sqrt(3.0) / 2) == 60);
  CHECK(acos_degrees(0.5) == 60);
  CHECK(acos_degrees(-0.5) == 120);
  CHECK(acos_degrees(-std::sqrt(0.5)) == 135);
  CHECK(acos_degrees(0) == 90);
  CHECK(atan_degrees(1) == 45);
  CHECK(atan_degrees(std::sqrt(3.0)) == 60);
  CHECK(atan_degrees(INFINITY) == 90);
  CHECK(atan2_degrees(0, -1) == 180);
  CHECK(atan2_degrees(-2, -2) == -135);
  CHECK(atan2_degrees(1, -std::sqrt(3.0)) == 150);
  for (int a = -90; a <= 90; ++a) {
    CHECK(asin_degrees(sin_degrees(a)) == a);
    CHECK(acos_degrees(cos_degrees(a + 90)) == a + 90);
  }
}

TEST_CASE("degrees: other angles are the library's, in radians") {
  for (const double a : {1e-9, 0.1, 44.999999, 45.000001, 89.5, 90.5, 179.0, 200.25, 300.1}) {
    const double radians = a * std::acos(-1.0) / 180;
    CHECK(sin_degrees(a) == Approx(std::sin(radians)).epsilon(1e-14));
    CHECK(cos_degrees(a) == Approx(std::cos(radians)).epsilon(1e-14).margin(1e-15));
  }
  CHECK(asin_degrees(0.3) == Approx(17.457603123722092).epsilon(1e-15));
  CHECK(std::isnan(sin_degrees(NAN)));
  CHECK(std::isnan(sin_degrees(INFINITY)));
}
