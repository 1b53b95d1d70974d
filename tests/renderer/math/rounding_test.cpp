#include "renderer/math/rounding.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using rt::tests::Random;

TEST_CASE("rounding: the bound is that of Higham's γ") {
  CHECK(rounding_bound(1) > 0x1p-53);
  CHECK(rounding_bound(1) < 1.0000001 * 0x1p-53);
  CHECK(rounding_bound(100) == Approx(100 * 0x1p-53).epsilon(1e-12));
}

TEST_CASE("rounding: a mapped point is no farther off than its bound") {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Affine map{random.vector(-3, 3), random.vector(-3, 3), random.vector(-3, 3), random.vector(-1e6, 1e6)};
    const Vec3 p = random.vector(-1e3, 1e3);
    const auto exact = [&](std::size_t axis) {
      return static_cast<long double>(map.x[axis]) * p.x + static_cast<long double>(map.y[axis]) * p.y +
             static_cast<long double>(map.z[axis]) * p.z + map.translation[axis];
    };
    const Vec3 image = map.point(p);
    long double off = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) off += (image[axis] - exact(axis)) * (image[axis] - exact(axis));
    CHECK(std::sqrt(static_cast<double>(off)) <= mapped_error(map, p, 0));
    const Vec3 moved = random.direction() * 1e-3;
    CHECK(length(map.vector(moved)) <= mapped_error(map, p, 1e-3));
  }
}
