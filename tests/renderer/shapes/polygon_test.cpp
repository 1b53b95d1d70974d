#include "renderer/shapes/polygon.hpp"
#include "renderer/shapes/triangle.hpp"
#include "tests/support/shapes.hpp"

#include <numbers>

using namespace rt;
using namespace rt::tests;

namespace {

PolygonGeometry outline(std::vector<Vec3> points) {
  scene::Polygon raw;
  raw.points = std::move(points);
  REQUIRE_FALSE(check(raw));
  return geometry(raw);
}

bool is_hit_from_above(const PolygonGeometry& polygon, double x, double z) {
  return !distances(polygon, {{x, 10, z}, {0, -1, 0}}).empty();
}

} // namespace

// The source notes' exercise 3: plane first, then every edge's inside.
TEST_CASE("polygon: a convex one agrees with the half-planes of its edges (exercise 3)") {
  const double pi = std::numbers::pi;
  std::vector<Vec3> points;
  for (int i = 0; i < 7; ++i) points.push_back({std::cos(2 * pi * i / 7), 0, -std::sin(2 * pi * i / 7)});
  const PolygonGeometry heptagon = outline(points);
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const double x = random.between(-1.2, 1.2), z = random.between(-1.2, 1.2);
    bool is_inside = true; // within cos(π/7) of the origin along every edge's direction
    for (int k = 0; k < 7; ++k) {
      const double angle = 2 * pi * (k + 0.5) / 7;
      is_inside = is_inside && x * std::cos(angle) - z * std::sin(angle) < std::cos(pi / 7);
    }
    CHECK(is_hit_from_above(heptagon, x, z) == is_inside);
  }
}

TEST_CASE("polygon: t, point and normal") {
  const PolygonGeometry square = geometry(scene::Polygon{});
  const Ray ray{{0.25, 0.5, 2}, {0, 0, -4}};
  CHECK(distances(square, ray) == std::vector<double>{0.5});
  CHECK(near(first_point(square, ray).position, {0.25, 0.5, 0}));
  CHECK(near(first_point(square, ray).normal, {0, 0, 1}));
  CHECK(distances(square, {{0.25, 0.5, 2}, {0, 0, 4}}).empty());
  CHECK(distances(square, {{-3, 0.5, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("polygon: edges and corners belong to it") {
  const PolygonGeometry square = outline({{0, 0, 0}, {2, 0, 0}, {2, 0, 2}, {0, 0, 2}});
  for (const double x : {0.0, 1.0, 2.0}) {
    for (const double z : {0.0, 1.0, 2.0}) CHECK(is_hit_from_above(square, x, z));
  }
  CHECK_FALSE(is_hit_from_above(square, 1, 2 + 1e-15));
  CHECK_FALSE(is_hit_from_above(square, -1e-300, 1));
}

TEST_CASE("polygon: a non-convex one is hollow between its arms") {
  std::vector<Vec3> points{{0, 0, 0}}; // a comb: 100 teeth from z = 1 to z = 3 on a bar from z = 0 to z = 1
  for (int i = 0; i < 100; ++i) {
    for (const auto& [x, z] : {std::pair{0.0, 3.0}, {0.5, 3.0}, {0.5, 1.0}, {1.0, 1.0}})
      points.push_back({i + x, 0, z});
  }
  points.push_back({100, 0, 0});
  const PolygonGeometry comb = outline(points);
  for (int i = 0; i < 100; ++i) {
    CHECK(is_hit_from_above(comb, i + 0.25, 2));
    CHECK_FALSE(is_hit_from_above(comb, i + 0.75, 2));
    CHECK(is_hit_from_above(comb, i + 0.75, 0.5));
    CHECK(is_hit_from_above(comb, i + 0.25, 1)); // level with many corners
  }
  CHECK_FALSE(is_hit_from_above(comb, -0.5, 1));
  CHECK_FALSE(is_hit_from_above(comb, 100.5, 1));
  CHECK_FALSE(is_hit_from_above(comb, -0.5, 3));
}

TEST_CASE("polygon: a seam leads to a hole, and is itself no gap") {
  const PolygonGeometry frame = outline(
      {{0, 0, 0}, {4, 0, 0}, {4, 0, 4}, {0, 0, 4}, {0, 0, 0}, {1, 0, 1}, {1, 0, 3}, {3, 0, 3}, {3, 0, 1}, {1, 0, 1}});
  CHECK(is_hit_from_above(frame, 0.5, 2));
  CHECK_FALSE(is_hit_from_above(frame, 2, 2));
  CHECK(is_hit_from_above(frame, 0.5, 0.5)); // on the seam
  CHECK(is_hit_from_above(frame, 0.4, 0.5));
  CHECK(is_hit_from_above(frame, 0.5, 0.4));
}

TEST_CASE("polygon: a tilted star agrees with its triangles") {
  const double pi = std::numbers::pi;
  const Vec3 u = normalize(Vec3{1, 2, -1}), v = normalize(cross(u, {0.3, 1, 2})), middle{0.5, -1, 2};
  const auto corner = [&](int i) {
    const double angle = pi * i / 5, radius = i % 2 == 0 ? 1 : 0.4;
    return middle + u * (radius * std::cos(angle)) + v * (radius * std::sin(angle));
  };
  std::vector<Vec3> points;
  std::vector<TriangleGeometry> fan;
  for (int i = 0; i < 10; ++i) {
    points.push_back(corner(i));
    fan.push_back({{middle, corner(i), corner(i + 1)}});
  }
  const PolygonGeometry star = outline(points);
  Random random(9);
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = middle + random.direction() * 5.0;
    const Ray ray{origin, middle + random.vector(-1, 1) - origin};
    std::vector<double> expected;
    for (const auto& triangle : fan) {
      const auto found = distances(triangle, ray);
      if (!found.empty()) expected = found;
    }
    CHECK(near(distances(star, ray), expected, 1e-13));
    count += expected.empty() ? 0 : 1;
  }
  CHECK(count > 300);
}

TEST_CASE("polygon: any map places it, mirrored or sheared") {
  const PolygonGeometry arrow = outline({{0, 0, 0}, {2, 0, 1}, {0, 0, 2}, {1, 0, 1}});
  const auto image = placed(arrow, Affine{{-1, 0, 0}, {0, 1, 0}, {0, 0.5, 1}, {0, 3, 0}}); // x' = −x, y' = y + z/2 + 3
  REQUIRE(image);
  CHECK(near(distances(*image, {{-1.5, 10, 1}, {0, -1, 0}}), {6.5}));
  CHECK(distances(*image, {{-0.5, 10, 1}, {0, -1, 0}}).empty());
  const Box3 box = bounds(arrow, Affine::translating({1, 1, 1}));
  CHECK(box.lower == Vec3{1, 1, 1});
  CHECK(box.upper == Vec3{3, 1, 3});
}
