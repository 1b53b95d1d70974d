#include "renderer/shapes/disc.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {
const DiscGeometry ring = geometry(scene::Disc{{0, 3, 0}, 2, 1});
}

TEST_CASE("disc: between hole and rim it is hit, both included") {
  const auto is_hit = [](double x) { return !distances(ring, {{x, 4, 0}, {0, -1, 0}}).empty(); };
  CHECK(is_hit(1.5));
  CHECK(is_hit(2));
  CHECK(is_hit(-1));
  CHECK_FALSE(is_hit(2 + 1e-15));
  CHECK_FALSE(is_hit(1 - 1e-15));
  CHECK_FALSE(is_hit(0));
}

TEST_CASE("disc: without a hole its middle is hit, from both sides, with one normal") {
  const DiscGeometry disc = geometry(scene::Disc{{0, 0, -2}, 1, 0});
  CHECK(distances(disc, {{0, 0, 3}, {0, 0, -1}}) == std::vector<double>{3});
  CHECK(near(first_point(disc, {{0, 0, 3}, {0, 0, -1}}).normal, {0, 0, -1}));
  CHECK(near(first_point(disc, {{0, 0, -3}, {0, 0, 1}}).normal, {0, 0, -1}));
}

TEST_CASE("disc: slanted rays, rays from behind and within its plane") {
  CHECK(near(distances(ring, {{-2, 3, 0}, {1.25, -6, 0.75}}), {0.5})); // at (−1.375, 0, 0.375)
  CHECK(distances(ring, {{1.5, 4, 0}, {0, 1, 0}}).empty());
  CHECK(distances(ring, {{-3, 0, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("disc: far from the world's origin it is as good as at it") {
  const auto far = placed(ring, Affine::translating({1e6, -1e6, 1e6}));
  REQUIRE(far);
  CHECK(distances(*far, {{1e6 + 1.5, -1e6 + 1, 1e6}, {0.125, -0.5, 0}}) == std::vector<double>{2});
}

TEST_CASE("disc: similar maps place it, others do not; its box is tight") {
  const auto moved =
      placed(ring, Affine::translating({0, 5, 0}) * Affine::rotating({0, 0, 1}, 90) * Affine::scaling({3, 3, -3}));
  REQUIRE(moved);
  CHECK(near(moved->normal, {-1, 0, 0}));
  CHECK(moved->radius == Approx(6));
  CHECK(moved->hole == Approx(3));
  CHECK_FALSE(placed(ring, Affine::scaling({2, 1, 1})));
  const double s = std::sqrt(0.5);
  const Box3 box = bounds(ring, Affine::rotating({0, 0, 1}, 45));
  CHECK(near(box.upper, {2 * s, 2 * s, 2}));
}
