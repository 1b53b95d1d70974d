#include "renderer/shapes/cone.hpp"
#include "renderer/shapes/cylinder.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {

ConeGeometry between(const Vec3& from, const Vec3& to, double radius, double top_radius, bool is_open = false) {
  return geometry(scene::Cone{from, to, radius, top_radius, is_open});
}

const ConeGeometry unit = geometry(scene::Cone{}); // radius 1 at y = 0, its point at y = 1
const ConeGeometry hat = between({0, 0, 0}, {0, 1, 0}, 1, 0, true);

} // namespace

TEST_CASE("cone: a ray across it") {
  const Ray ray{{-3, 0.25, 0}, {1, 0, 0}}; // where the radius is ¾
  CHECK(near(distances(unit, ray), {2.25, 3.75}));
  const SurfacePoint point = first_point(unit, ray);
  CHECK(near(point.position, {-0.75, 0.25, 0}));
  CHECK(near(point.normal, Vec3{-1, 1, 0} / std::sqrt(2.0)));
  CHECK(distances(unit, {{-3, 1.5, 0}, {1, 0, 0}}).empty());  // above its point, through the other nappe
  CHECK(distances(unit, {{-3, -0.5, 0}, {1, 0, 0}}).empty()); // below its base
  CHECK(distances(unit, {{3, 0.25, 0}, {1, 0, 0}}).empty());  // behind the ray
}

TEST_CASE("cone: a ray along the axis goes through point and base") {
  CHECK(near(distances(unit, {{0, 3, 0}, {0, -1, 0}}), {2, 3}));
  CHECK(near(distances(unit, {{0.25, 3, 0}, {0, -1, 0}}), {2.25, 3}));
  CHECK(near(distances(hat, {{0.25, 3, 0}, {0, -1, 0}}), {2.25}));
  CHECK(near(distances(unit, {{0.25, -1, 0}, {0, 1, 0}}), {1, 1.75}));
  CHECK(distances(unit, {{1.25, 3, 0}, {0, -1, 0}}).empty());
}

TEST_CASE("cone: a ray parallel to a line of its side crosses the side once") {
  // (−3 + t, 3.2 − t) is on y = 1 + x for t = 2.6, and at the base, at x = 0.2, for t = 3.2.
  const auto found = hits(unit, {{-3, 3.2, 0}, {1, -1, 0}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].t == Approx(2.6).epsilon(1e-15));
  CHECK(found[0].part == side_part);
  CHECK(found[1].t == Approx(3.2).epsilon(1e-15));
  CHECK(found[1].part == base_part);
  // Almost parallel: in 60 digits, at
  CHECK(near(distances(unit, {{-3, 3.2, 0}, {1, -1 + 0x1p-40, 0}}), {2.6000000000011824319, 3.2000000000029105607}));
}

TEST_CASE("cone: a ray within a line of its side does not meet the side") {
  CHECK(distances(hat, {{-1, 2, 0}, {1, -1, 0}}).empty());
}

TEST_CASE("cone: rays from inside") {
  CHECK(near(distances(unit, {{0, 0.5, 0}, {0, 0, 1}}), {0.5}));
  CHECK(near(distances(unit, {{0, 0.5, 0}, {0, -2, 0}}), {0.25}));
  CHECK(near(distances(unit, {{0, 0.5, 0}, {0, 2, 0}}), {0.25})); // the point
  CHECK(distances(hat, {{0, 0.5, 0}, {0, -2, 0}}).empty());
}

TEST_CASE("cone: steeper and flatter rays than its side, through both ends") {
  const ConeGeometry frustum = between({0, 0, 0}, {0, 2, 0}, 1, 2);
  // Enters through the base at x = ½ and leaves through the top at x = 1½.
  const auto up = hits(frustum, {{0, -1, 0}, {0.5, 1, 0}});
  REQUIRE(up.size() == 2);
  CHECK(up[0].t == 1);
  CHECK(up[0].part == base_part);
  CHECK(up[1].t == 3);
  CHECK(up[1].part == top_part);
  // Across: the side is x = ±(1 + y/2), at y = 1 that is ±1½.
  CHECK(near(distances(frustum, {{-3, 1, 0}, {1, 0, 0}}), {1.5, 4.5}));
  // In through the top, out through the side at y = 1: from (0, 3) by (1½, −2).
  const auto out = hits(frustum, {{0, 3, 0}, {1.5, -2, 0}});
  REQUIRE(out.size() == 2);
  CHECK(out[0].part == top_part);
  CHECK(out[0].t == 0.5);
  CHECK(out[1].part == side_part);
  CHECK(out[1].t == 1);
}

TEST_CASE("cone: with equal radii it is a cylinder") {
  const ConeGeometry cone = between({1, 0, 2}, {2, 3, 1}, 0.75, 0.75);
  scene::Cylinder raw;
  raw.from = Vec3{1, 0, 2}, raw.to = Vec3{2, 3, 1}, raw.radius = 0.75;
  const CylinderGeometry cylinder = geometry(raw);
  Random random(1);
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 origin = random.vector(-5, 5), target = random.vector(0, 3);
    const auto expected = distances(cylinder, {origin, target - origin});
    CHECK(near(distances(cone, {origin, target - origin}), expected, 1e-12));
    count += expected.empty() ? 0 : 1;
  }
  CHECK(count > 200);
}

// The expected numbers below were computed with 60 digits from the same doubles.
TEST_CASE("cone: tilted ones, from near and from far") {
  const ConeGeometry cone = between({1, 2, 3}, {4, 6, 15}, 4, 0);
  CHECK(near(distances(cone, {{-6, 3, 20}, {1, 0.25, -0.9}}), {8.40435559216130303, 9.9774537680938137712}, 1e-15));
  CHECK(near(distances(cone, {{-6e5, 3e5, -8e5}, {6e5 + 2.5, -3e5 + 4, 8e5 + 9}}),
             {0.99999552900465540466, 1.000002150135010814}, 3e-16));
  const ConeGeometry frustum = between({1, 2, 3}, {4, 6, 15}, 2, 5);
  CHECK(
      near(distances(frustum, {{-6, 3, 20}, {1, 0.25, -0.9}}), {5.4038635419486146025, 12.122422375305849819}, 1e-15));
  const ConeGeometry open = between({0, 0, 0}, {0, 2, 0}, 1, 2, true);
  CHECK(near(distances(open, {{-3, 1.5, 0.25}, {1, -0.125, 0.0625}}), {1.369800677650963065, 4.380199322349036935},
             1e-15));
}

TEST_CASE("cone: a tiny one") {
  CHECK(near(distances(between({0, 0, 0}, {0, 1e-6, 0}, 1e-6, 0), {{1, 2, 3}, {-1, -1.9999997, -3}}),
             {0.99999986440093175775, 1.0000001500000224766}));
}

TEST_CASE("cone: as a solid") {
  CHECK(is_solid(unit));
  CHECK_FALSE(is_solid(hat));
  CHECK(near(span(unit, {{3, 0.25, 0}, {1, 0, 0}}), {-3.75, -2.25}));
  CHECK(near(span(unit, {{0.25, -1, 0}, {0, 1, 0}}), {1, 1.75}));
  CHECK(span(unit, {{-3, 1.5, 0}, {1, 0, 0}}).empty());
  CHECK(contains(unit, {0.4, 0.5, 0}));
  CHECK_FALSE(contains(unit, {0.6, 0.5, 0}));
  CHECK_FALSE(contains(unit, {0.1, 1.5, 0})); // the other nappe
}

TEST_CASE("cone: its point has a normal, along the axis") {
  const SurfacePoint tip = first_point(unit, {{0, 3, 0}, {0, -1, 0}});
  CHECK(near(tip.position, {0, 1, 0}));
  CHECK(near(tip.normal, {0, 1, 0}));
}

TEST_CASE("cone: similar maps place it; its box is tight") {
  const auto moved =
      placed(unit, Affine::translating({0, 0, 7}) * Affine::rotating({1, 0, 0}, 90) * Affine::scaling({2, 2, 2}));
  REQUIRE(moved); // base at z = 7 with radius 2, its point at z = 9
  CHECK(near(distances(*moved, {{-3, 0, 8}, {1, 0, 0}}), {2, 4}));
  CHECK_FALSE(placed(unit, Affine::scaling({1, 2, 1})));
  const Box3 box = bounds(unit, Affine::rotating({0, 0, 1}, -90)); // its point at (1, 0, 0)
  CHECK(near(box.lower, {0, -1, -1}));
  CHECK(near(box.upper, {1, 1, 1}));
}
