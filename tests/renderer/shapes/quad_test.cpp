#include "renderer/shapes/quad.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

TEST_CASE("quad: a square about the origin") {
  scene::Quad raw;
  raw.size = 4, raw.normal = Vec3{0, 0, 2};
  const QuadGeometry square = geometry(raw);
  CHECK(near(distances(square, {{1.9, -1.9, 3}, {0, 0, -2}}), {1.5}));
  CHECK(distances(square, {{2, 2, 3}, {0, 0, -1}}) == std::vector<double>{3}); // its corner
  CHECK(distances(square, {{2.1, 0, 3}, {0, 0, -1}}).empty());
  CHECK(distances(square, {{0, 0, 3}, {0, 0, 1}}).empty());
  CHECK(distances(square, {{-3, 0, 0}, {1, 0, 0}}).empty()); // within its plane
  CHECK(near(first_point(square, {{0, 0, -3}, {0, 0, 1}}).normal, {0, 0, 1}));
}

TEST_CASE("quad: a square stands upright, its edges level") {
  scene::Quad raw;
  raw.size = 2;
  CHECK(near(geometry(raw).normal, {0, 1, 0}));
  CHECK(near(geometry(raw).points[2], {1, 0, -1})); // u = x, v = y × x = −z
  raw.normal = Vec3{3, 0, 4};
  const QuadGeometry square = geometry(raw); // u = y × n = (0.8, 0, −0.6), v = y
  CHECK(near(square.points[0], {-0.8, -1, 0.6}));
  CHECK(near(square.points[1], {0.8, -1, -0.6}));
  CHECK(near(square.points[2], {0.8, 1, -0.6}));
  CHECK(near(square.points[3], {-0.8, 1, 0.6}));
}

TEST_CASE("quad: a parallelogram") {
  scene::Quad raw;
  raw.corner = Vec3{1, 1, 1}, raw.edge_u = Vec3{2, 0, 0}, raw.edge_v = Vec3{1, 2, 0};
  const QuadGeometry quad = geometry(raw);
  CHECK(near(quad.normal, {0, 0, 1}));
  const auto is_hit = [&](double x, double y) { return !distances(quad, {{x, y, 5}, {0, 0, -1}}).empty(); };
  CHECK(is_hit(2, 1.5));
  CHECK(is_hit(3.9, 2.95));
  CHECK_FALSE(is_hit(1.1, 2));
  CHECK_FALSE(is_hit(3.5, 1.5));
  CHECK(is_hit(1.5, 2)); // on its slanted edge
}

TEST_CASE("quad: four points of a plane, also with a dent") {
  scene::Quad raw;
  raw.points = std::vector<Vec3>{{0, 0, 0}, {4, 0, 4}, {1, 1, 1}, {0, 4, 0}}; // in the plane z = x
  const QuadGeometry quad = geometry(raw);
  CHECK(near(distances(quad, {{0.5, 0.5, 3}, {0, 0, -1}}), {2.5}));
  CHECK(near(distances(quad, {{3, 0.2, 4}, {0, 0, -1}}), {1}));
  CHECK(distances(quad, {{1.5, 1.5, 4}, {0, 0, -1}}).empty()); // in the dent
}

TEST_CASE("quad: any map places it") {
  const auto quad = placed(geometry(scene::Quad{}), Affine{{2, 1, 0}, {0, 1, 0}, {0, 0, -3}, {0, 7, 0}});
  REQUIRE(quad); // corners (±½, 0, ±½) become (±1, 7 ± ½, ∓1½)
  CHECK(near(distances(*quad, {{0.5, 10, 1}, {0, -1, 0}}), {2.75}));
  CHECK(near(first_point(*quad, {{0.5, 10, 1}, {0, -1, 0}}).normal, Vec3{-1, 2, 0} / std::sqrt(5.0)));
  CHECK(near(bounds(geometry(scene::Quad{}), Affine::scaling({2, 1, 4})).upper, {1, 0, 2}));
}
