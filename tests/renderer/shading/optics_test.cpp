#include "renderer/shading/optics.hpp"

#include <catch2/catch.hpp>

using namespace rt;

TEST_CASE("optics: whole powers by multiplying, all others by the library") {
  CHECK(to_power(0.5, 1) == 0.5);
  CHECK(to_power(0.5, 10) == 0x1p-10);
  CHECK(to_power(0.75, 3) == 0.421875); // 27/64, exactly
  CHECK(to_power(1, 200) == 1);
  CHECK(to_power(0, 60) == 0);
  CHECK(to_power(0.25, 0.5) == 0.5);
  CHECK(to_power(0.5, 0) == 1);
  CHECK(to_power(0.5, 1000) == 0x1p-1000);
  CHECK(to_power(0.5, 1e300) == 0);
  // By long multiplication. Each unit of the exponent adds a rounding at most.
  CHECK(to_power(0.9, 60) == Approx(0.00179701029991443387).epsilon(1e-13));
  CHECK(to_power(0.99, 255) == Approx(0.0770858423298927265).epsilon(1e-13));
  CHECK(to_power(0.999, 256) == Approx(0.774042818860508108).epsilon(1e-13));
}
