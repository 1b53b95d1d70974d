#include "renderer/math/quadratic.hpp"

#include <catch2/catch.hpp>

using namespace rt;

TEST_CASE("quadratics: both roots are precise where one would cancel") {
  // t² − 2·10⁸ t + 1 = 0: the roots 10⁸ ± √(10¹⁶ − 1), the smaller one 5.0000000000000000125e-9.
  const QuadraticRoots roots(1, -1e8, 1, 1e16 - 1);
  CHECK(roots.first == 2e8);
  CHECK(roots.second == 5e-9);
  const QuadraticRoots mirrored(1, 1e8, 1, 1e16 - 1);
  CHECK(mirrored.first == -2e8);
  CHECK(mirrored.second == -5e-9);
}

TEST_CASE("quadratics: double roots, and the one root of a line") {
  const QuadraticRoots twice(2, -3, 4.5, 0);
  CHECK(twice.first == 1.5);
  CHECK(twice.second == 1.5);
  const QuadraticRoots zero(2, 0, 0, 0);
  CHECK(zero.first == 0);
  CHECK(zero.second == 0);
  const QuadraticRoots line(0, 2, -6, 4); // 4 t − 6 = 0
  CHECK(std::isinf(line.first));
  CHECK(line.second == 1.5);
}
