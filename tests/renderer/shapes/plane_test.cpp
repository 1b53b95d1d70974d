#include "renderer/shapes/plane.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

PlaneGeometry through(const Vec3& point, const Vec3& normal) {
  scene::Plane plane;
  plane.normal = normal;
  plane.offset = dot(point, normalize(normal));
  return geometry(plane);
}

} // namespace

// The source notes' exercise 2.
TEST_CASE("plane: a ray that meets it head on (exercise 2, case 1)") {
  // t = (N·V₀ − N·O) / (N·R) = (−2 − 0) / (−1)
  const PlaneGeometry plane = through({2, 0, 0}, {-1, 0, 0});
  CHECK(near(distances(plane, {{0, 0, 0}, {1, 0, 0}}), {2}));
  CHECK(near(first_point(plane, {{0, 0, 0}, {1, 0, 0}}).position, {2, 0, 0}));
}

TEST_CASE("plane: a parallel ray does not meet it, not even within it (exercise 2, case 2)") {
  const PlaneGeometry plane = through({2, 0, 0}, {0, 1, 0});
  CHECK(distances(plane, {{0, 0, 0}, {1, 0, 0}}).empty()); // within it: y = 0 on both
  CHECK(distances(plane, {{0, 1, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("plane: a slanted ray and a slanted plane (exercise 2, case 3)") {
  CHECK(near(distances(through({3, 3, 3}, {1, 1, 0}), {{0, 0, 0}, {1, 1, 1}}), {3}, 3e-16));
}

TEST_CASE("plane: what lies behind the ray is not hit") {
  CHECK(distances(through({0, -1, 0}, {0, 1, 0}), {{0, 0, 0}, {1, 2, 3}}).empty());
}

TEST_CASE("plane: the offset counts along the unit normal") {
  scene::Plane plane;
  plane.normal = Vec3{0, 3, 4};
  plane.offset = 10;
  CHECK(near(distances(geometry(plane), {{0, 0, 0}, {0, 0.6, 0.8}}), {10}, 3e-16));
}

TEST_CASE("plane: the short forms face along their axis, exactly") {
  scene::Plane x, y, z;
  x.x = 3, y.y = -0.1, z.z = 1e6;
  CHECK(near(distances(geometry(x), {{0, 0, 0}, {2, 1, 1}}), {1.5}));
  CHECK(first_point(geometry(y), {{0.3, 7, 0.1}, {0.1, -1, 0.7}}).position.y == -0.1);
  CHECK(near(distances(geometry(z), {{0, 0, 0}, {0, 0, 1}}), {1e6}));
  CHECK(geometry(x).normal == Vec3{1, 0, 0});
  CHECK(geometry(scene::Plane{}).normal == Vec3{0, 1, 0});
  CHECK(geometry(scene::Plane{}).offset == 0);
}

TEST_CASE("plane: the notes' planes x + y + z = 1 and x − 2y + 3z = 1 meet at arccos(2/√42)") {
  const Vec3 a = through({1, 0, 0}, {1, 1, 1}).normal, b = through({1, 0, 0}, {1, -2, 3}).normal;
  CHECK(dot(a, b) == Approx(2 / std::sqrt(42.0)).epsilon(1e-15));
}

TEST_CASE("plane: its solid side is the one the normal points away from") {
  const PlaneGeometry floor = through({0, 2, 0}, {0, 1, 0});
  CHECK(span(floor, {{0, 5, 0}, {0, -1, 0}}) == std::vector<double>{3, infinity});
  CHECK(span(floor, {{0, 5, 0}, {0, 1, 0}}) == std::vector<double>{-infinity, -3});
  CHECK(span(floor, {{0, 1, 0}, {1, 0, 0}}) == std::vector<double>{-infinity, infinity});
  CHECK(span(floor, {{0, 2, 0}, {1, 0, 0}}).empty());
  CHECK(span(floor, {{0, 3, 0}, {1, 0, 0}}).empty());
  CHECK(contains(floor, {9, 1.99, 9}));
  CHECK_FALSE(contains(floor, {9, 2, 9}));
}

TEST_CASE("plane: any invertible map places it, solid side included") {
  const PlaneGeometry floor = through({0, 2, 0}, {0, 1, 0});
  // Doubled in y, then turned by 90° about z: y = 2 becomes y = 4 becomes x = −4, the upper side at smaller x.
  const auto turned = placed(floor, Affine::rotating({0, 0, 1}, 90) * Affine::scaling({5, 2, 1}));
  REQUIRE(turned);
  CHECK(near(turned->normal, {-1, 0, 0}));
  CHECK(turned->offset == 4);
  // x' = x + y: the plane x = 1 becomes x' − y' = 1.
  const auto sheared = placed(through({1, 0, 0}, {1, 0, 0}), Affine{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {}});
  REQUIRE(sheared);
  CHECK(near(sheared->normal, Vec3{1, -1, 0} / std::sqrt(2.0)));
  CHECK(sheared->offset == Approx(1 / std::sqrt(2.0)).epsilon(1e-15));
  CHECK_FALSE(placed(floor, Affine::scaling({1, 0, 1})));
}

TEST_CASE("plane: its box is the half-space where that is one, else all space") {
  const Box3 below = bounds(through({0, 2, 0}, {0, 1, 0}));
  CHECK(below.upper == Vec3{infinity, 2, infinity});
  CHECK(below.lower == Vec3{-infinity, -infinity, -infinity});
  CHECK(bounds(through({0, 2, 0}, {0, -1, 0})).lower.y == 2);
  CHECK(bounds(through({0, 2, 0}, {1, 1, 0})) == all_space());
}
