#include "renderer/shapes/sphere.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {
const SphereGeometry unit{{}, 1};
}

// The source notes' exercise 1.
TEST_CASE("sphere: a ray from outside crosses it twice (exercise 1, case 1)") {
  CHECK(near(distances(SphereGeometry{{2, 0, 0}, 1}, {{0, 0, 0}, {1, 0, 0}}), {1, 3}));
}

TEST_CASE("sphere: what lies behind the ray is not hit (exercise 1, case 2)") {
  CHECK(distances(SphereGeometry{{-2, 0, 0}, 1}, {{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("sphere: a ray from inside hits the far wall (exercise 1, case 3)") {
  CHECK(near(distances(SphereGeometry{{0, 0, 0}, 4}, {{0, 0, 0}, {1, 0, 0}}), {4}));
}

TEST_CASE("sphere: t counts lengths of a direction that is no unit vector (exercise 1, case 4)") {
  // 3 t² − 5.6 t + 1.64 = 0
  const double root = std::sqrt(11.68);
  CHECK(near(distances(SphereGeometry{{1, 1, 0.8}, 1}, {{0, 0, 0}, {1, 1, 1}}), {(5.6 - root) / 6, (5.6 + root) / 6},
             4e-16));
}

TEST_CASE("sphere: a ray that passes by misses (exercise 1, case 5)") {
  // The centre (4, 4, 0) is √(32 − 64/3) = 3.266 from the line, the radius 2.
  CHECK(distances(SphereGeometry{{4, 4, 0}, 2}, {{0, 0, 0}, {1, 1, 1}}).empty());
}

TEST_CASE("sphere: the notes' circle x² + y² = 4 is met at ±√2, by the ray from (−3, −3) along (1, 1)") {
  const SphereGeometry circle{{}, 2};
  const Ray ray{{-3, -3, 0}, {1, 1, 0}};
  const auto found = hits(circle, ray);
  REQUIRE(found.size() == 2);
  CHECK(found[0].t == Approx(3 - std::sqrt(2.0)).epsilon(1e-15));
  CHECK(found[1].t == Approx(3 + std::sqrt(2.0)).epsilon(1e-15));
  const double s = std::sqrt(2.0);
  CHECK(near(surface_point(circle, ray, found[0]).position, {-s, -s, 0}, 1e-15));
  CHECK(near(surface_point(circle, ray, found[1]).position, {s, s, 0}, 1e-15));
  // As a distance: (3 − √2)·√2 = 3√2 − 2.
  CHECK(length(ray.direction) * found[0].t == Approx(3 * std::sqrt(2.0) - 2).epsilon(1e-15));
}

TEST_CASE("sphere: a tangent touches it once, and does not enter it") {
  const Ray tangent{{-3, 1, 0}, {1, 0, 0}};
  CHECK(near(distances(unit, tangent), {3}));
  CHECK(span(unit, tangent).empty());
  CHECK(distances(unit, {{-3, 1 + 1e-15, 0}, {1, 0, 0}}).empty());
  CHECK(span(unit, {{-3, 1 - 1e-15, 0}, {1, 0, 0}}).size() == 2);
}

TEST_CASE("sphere: a grazing ray keeps both crossings apart") {
  // √(1 − (1 − 2⁻⁴⁰)²) is 1.348699e-6: in 60 digits, the crossings are at
  CHECK(
      near(distances(unit, {{-5, 1 - 0x1p-40, 0}, {1, 0, 0}}), {4.9999986513008476517, 5.0000013486991523483}, 1e-15));
}

TEST_CASE("sphere: the interval is open below and closed above") {
  const Ray ray{{-3, 0, 0}, {1, 0, 0}}; // hits at 2 and 4
  Hit hit;
  CHECK((intersect(unit, ray, {0, 2}, hit) && hit.t == 2));
  CHECK((intersect(unit, ray, {2, 4}, hit) && hit.t == 4));
  CHECK_FALSE(intersect(unit, ray, {2, 3.9}, hit));
  CHECK_FALSE(intersect(unit, ray, {4, 100}, hit));
  CHECK_FALSE(intersect(unit, ray, {0, 1.9}, hit));
}

TEST_CASE("sphere: a ray that starts on it and leads away does not meet it") {
  CHECK(distances(unit, {{1, 0, 0}, {1, 0.5, 0}}).empty());
  CHECK(distances(unit, {{0, 1, 0}, {1, 0, 0}}).empty()); // tangent
  CHECK(near(distances(unit, {{0, 1, 0}, {0, -2, 0}}), {1}));
}

// The expected numbers below were computed with 60 digits from the same doubles.
TEST_CASE("sphere: far origins cost no relative precision") {
  CHECK(near(distances(unit, {{1e6, 0.3, -0.2}, {-1, 0, 0}}), {999999.06726209469112, 1000000.9327379053089}, 3e-16));
  CHECK(near(distances(unit, {{-6e5, 8e5, 0.25}, {0.6, -0.8, 0}}), {999999.03175416342594, 1000000.9682458365296},
             3e-16));
}

TEST_CASE("sphere: far from the world's origin it is as good as at it") {
  const SphereGeometry sphere{{1e6, 1e6, 1e6}, 2};
  const Ray ray{{1e6 + 4, 1e6, 1e6 - 3}, {-4, 0.5, 3}};
  CHECK(near(distances(sphere, ray), {0.60459559734788544499, 1.375602422454094753}, 1e-15));
  CHECK(near(first_point(sphere, ray).normal,
             {2 - 2 * 0.60459559734788544499, 0.25 * 0.60459559734788544499, -1.5 + 1.5 * 0.60459559734788544499},
             1e-15));
}

TEST_CASE("sphere: tiny and huge radii") {
  const SphereGeometry tiny{{}, 1e-6};
  CHECK(near(distances(tiny, {{1, 2, 3}, {-1, -2.0000003, -3}}), {0.99999969861484941233, 1.0000002156708593766}));
  const SphereGeometry far{{1e6, 0, 0}, 1e-6};
  CHECK(near(distances(far, {{1e6 + 1, 0, 0}, {-1, 0, 2e-7}}), {0.99999902020406288675, 1.0000009797958571133}));
  const SphereGeometry ground{{0, -1e6, 0}, 1e6};
  CHECK(near(distances(ground, {{3, 2, 1}, {0.25, -1, 0.5}}), {2.0000081250152344469, 1523808.6666585416514}, 1e-15));
}

TEST_CASE("sphere: its normal points out of it, from whichever side it is seen") {
  const SphereGeometry sphere{{1, 2, 3}, 2};
  const SurfacePoint outside = first_point(sphere, {{1, 2, 9}, {0, 0, -1}});
  CHECK(near(outside.position, {1, 2, 5}));
  CHECK(near(outside.normal, {0, 0, 1}));
  const SurfacePoint inside = first_point(sphere, {{1, 2, 3}, {0, 0, -1}});
  CHECK(near(inside.position, {1, 2, 1}));
  CHECK(near(inside.normal, {0, 0, -1}));
}

TEST_CASE("sphere: as a solid, a line is inside between its crossings, before or behind the origin") {
  CHECK(near(span(unit, {{-3, 0, 0}, {1, 0, 0}}), {2, 4}));
  CHECK(near(span(unit, {{3, 0, 0}, {1, 0, 0}}), {-4, -2}));
  CHECK(near(span(unit, {{0, 0, 0}, {0, 0.5, 0}}), {-2, 2}));
  CHECK(span(unit, {{-3, 2, 0}, {1, 0, 0}}).empty());
  CHECK(is_solid(unit));
  CHECK(contains(unit, {0.5, 0.5, 0.5}));
  CHECK_FALSE(contains(unit, {1, 0, 0}));
  CHECK_FALSE(contains(unit, {0.6, 0.6, 0.6}));
}

TEST_CASE("sphere: maps that keep it round place it, others do not") {
  const SphereGeometry sphere = geometry(scene::Sphere{2});
  const auto moved =
      placed(sphere, Affine::translating({1, 2, 3}) * Affine::rotating({1, 1, 0}, 33) * Affine::scaling({-3, 3, 3}));
  REQUIRE(moved);
  CHECK(near(moved->center, {1, 2, 3}));
  CHECK(moved->radius == Approx(6).epsilon(1e-15));
  CHECK_FALSE(placed(sphere, Affine::scaling({1, 1, 1.001})));
  CHECK_FALSE(placed(sphere, Affine{{1, 0, 0}, {0.001, 1, 0}, {0, 0, 1}, {}}));
}

TEST_CASE("sphere: the box around an ellipsoid is tight") {
  // Scaled by (1, 2, 3), turned by 90° about z: half axes 2, 1, 3.
  const Box3 box =
      bounds(unit, Affine::translating({10, 0, 0}) * Affine::rotating({0, 0, 1}, 90) * Affine::scaling({1, 2, 3}));
  CHECK(near(box.lower, {8, -1, -3}));
  CHECK(near(box.upper, {12, 1, 3}));
  // A ball is as wide whichever way it is turned.
  const Box3 turned = bounds(unit, Affine::rotating({1, 2, 3}, 40));
  CHECK(near(turned.lower, {-1, -1, -1}));
}
