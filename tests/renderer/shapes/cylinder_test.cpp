#include "renderer/shapes/cylinder.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {

CylinderGeometry between(const Vec3& from, const Vec3& to, double radius, bool is_open = false) {
  scene::Cylinder cylinder;
  cylinder.from = from, cylinder.to = to;
  cylinder.radius = radius, cylinder.open = is_open;
  return geometry(cylinder);
}

CylinderGeometry endless(const Vec3& axis, double radius) {
  scene::Cylinder cylinder;
  cylinder.axis = axis, cylinder.radius = radius, cylinder.infinite = true;
  return geometry(cylinder);
}

const CylinderGeometry standing = between({0, 0, 0}, {0, 2, 0}, 1);
const CylinderGeometry tube = between({0, 0, 0}, {0, 2, 0}, 1, true);

} // namespace

// The source notes' exercise 4: a = vx² + vy², b = 2 (px vx + py vy), c = px² + py² − r².
TEST_CASE("cylinder: a vertical one about the origin (exercise 4)") {
  // p = (−4, 0, 1), v = (1, ¼, ½), r = 2: 1.0625 t² − 8 t + 12 = 0
  const double root = std::sqrt(64 - 4 * 1.0625 * 12);
  CHECK(near(distances(endless({0, 0, 1}, 2), {{-4, 0, 1}, {1, 0.25, 0.5}}), {(8 - root) / 2.125, (8 + root) / 2.125}));
  // p = (−3, 1, 2), v = (1, ½, ¼): 1.25 t² − 5 t + 6 = 0 has the discriminant 25 − 30.
  CHECK(distances(endless({0, 0, 1}, 2), {{-3, 1, 2}, {1, 0.5, 0.25}}).empty());
}

TEST_CASE("cylinder: a vertical one about (a, b) (exercise 4)") {
  const auto moved = placed(endless({0, 0, 1}, 2), Affine::translating({1.5, -2, 0}));
  REQUIRE(moved);
  const double root = std::sqrt(64 - 4 * 1.0625 * 12);
  CHECK(near(distances(*moved, {{-2.5, -2, 1}, {1, 0.25, 0.5}}), {(8 - root) / 2.125, (8 + root) / 2.125}));
}

TEST_CASE("cylinder: a ray across it") {
  CHECK(near(distances(standing, {{-3, 1, 0.6}, {1, 0, 0}}), {2.2, 3.8}, 3e-16));
  const SurfacePoint near_side = first_point(standing, {{-3, 1, 0.6}, {1, 0, 0}});
  CHECK(near(near_side.position, {-0.8, 1, 0.6}));
  CHECK(near(near_side.normal, {-0.8, 0, 0.6}));
  CHECK(distances(standing, {{-3, 2.1, 0}, {1, 0, 0}}).empty()); // above it
  CHECK(distances(standing, {{3, 1, 0}, {1, 0, 0}}).empty());    // behind the ray
  CHECK(distances(standing, {{-3, 1, 1.1}, {1, 0, 0}}).empty()); // beside it
}

TEST_CASE("cylinder: in through an end, out through the side") {
  const Ray ray{{0, 3, 0}, {1, -2, 0}}; // at the top, y = 2, for t = ½; at x = 1 for t = 1, y = 1
  const auto found = hits(standing, ray);
  REQUIRE(found.size() == 2);
  CHECK(found[0].t == 0.5);
  CHECK(found[0].part == top_part);
  CHECK(found[1].t == 1);
  CHECK(found[1].part == side_part);
  CHECK(near(surface_point(standing, ray, found[0]).normal, {0, 1, 0}));
  CHECK(near(surface_point(standing, ray, found[1]).normal, {1, 0, 0}));
}

TEST_CASE("cylinder: a ray along the axis goes through both ends") {
  CHECK(near(distances(standing, {{0.5, 5, 0.5}, {0, -1, 0}}), {3, 5}));
  CHECK(near(distances(standing, {{0.5, 1, 0.5}, {0, -4, 0}}), {0.25})); // from inside
  CHECK(distances(standing, {{0.8, 5, 0.8}, {0, -1, 0}}).empty());
  CHECK(distances(tube, {{0.5, 5, 0.5}, {0, -1, 0}}).empty());
  CHECK(distances(endless({0, 1, 0}, 1), {{0.5, 5, 0.5}, {0, -1, 0}}).empty());
  CHECK(distances(tube, {{1, 5, 0}, {0, -1, 0}}).empty()); // within the side: does not meet it
}

TEST_CASE("cylinder: a ray into an open one meets its inner wall") {
  const Ray ray{{0, 3, 0}, {1, -2, 0}};
  const auto found = hits(tube, ray);
  REQUIRE(found.size() == 1);
  CHECK(found[0].t == 1);
  CHECK(near(surface_point(tube, ray, found[0]).normal, {1, 0, 0})); // outward, not to the viewer
}

TEST_CASE("cylinder: rays from inside meet the side, the end, or nothing") {
  CHECK(near(distances(standing, {{0, 1, 0}, {0, 0, 4}}), {0.25}));
  CHECK(near(distances(standing, {{0, 1, 0}, {0, 1, 0.5}}), {1}));
  CHECK(distances(tube, {{0, 1, 0}, {0, 1, 0.5}}).empty());
}

TEST_CASE("cylinder: a tangent touches its side once and does not enter it") {
  CHECK(near(distances(standing, {{-3, 1, 1}, {1, 0, 0}}), {3}));
  CHECK(span(standing, {{-3, 1, 1}, {1, 0, 0}}).empty());
}

TEST_CASE("cylinder: a ray along the rim of an end meets the side there") {
  CHECK(near(distances(standing, {{-3, 2, 0}, {1, 0, 0}}), {2, 4}));
  CHECK(near(distances(tube, {{-3, 0, 0}, {1, 0, 0}}), {2, 4}));
}

TEST_CASE("cylinder: both ways of writing it agree") {
  scene::Cylinder about; // half of the height each way
  about.axis = Vec3{0, 0, -7}, about.height = 3, about.radius = 0.5;
  const Ray ray{{2, 1, 2.5}, {-1, -0.5, -0.75}};
  const auto expected = distances(between({0, 0, 1.5}, {0, 0, -1.5}, 0.5), ray);
  CHECK(expected.size() == 2);
  CHECK(distances(geometry(about), ray) == expected);
  const CylinderGeometry plain = geometry(scene::Cylinder{});
  CHECK(plain.base == Vec3{0, -0.5, 0});
  CHECK(plain.axis == Vec3{0, 1, 0});
  CHECK(plain.height == 1);
}

// The expected numbers below were computed with 60 digits from the same doubles.
TEST_CASE("cylinder: a tilted one, from near and from far") {
  const CylinderGeometry tilted = between({1, 2, 3}, {4, 6, 15}, 2);
  CHECK(near(distances(tilted, {{-6, 3, 20}, {1, 0.25, -0.9}}), {7.526731912898671039, 10.643041876248759117}, 1e-15));
  CHECK(near(distances(tilted, {{-6e5, 3e5, -8e5}, {6e5 + 2.5, -3e5 + 4, 8e5 + 9}}),
             {0.9999970961926113577, 1.0000029038073886423}, 3e-16));
}

TEST_CASE("cylinder: far from the world's origin it is as good as at it") {
  const CylinderGeometry far = between({1e6, 1e6, 0}, {1e6 + 3, 1e6 + 4, 0}, 0.5);
  CHECK(near(distances(far, {{1e6 + 1, 1e6 - 2, 0.125}, {0.25, 2, 0.0625}}),
             {1.5519861793167376029, 2.4168854160140016968}, 1e-15));
}

TEST_CASE("cylinder: tiny and huge ones") {
  CHECK(near(distances(between({0, 0, 0}, {0, 1e-6, 0}, 1e-6), {{1, 2, 3}, {-1, -1.9999995, -3}}),
             {0.99999974999993753493, 1.000000250000062535}));
  CHECK(near(distances(between({-1e6, 0, 0}, {1e6, 0, 0}, 1e6), {{5, 1, 2}, {0.5, 1, 0.25}}), {970141.08837922786518}));
}

TEST_CASE("cylinder: a needle seen along itself") {
  const CylinderGeometry needle = between({0, 0, 0}, {0, 1000, 0}, 1e-3);
  const auto found = hits(needle, {{0.0005, -1, 0.0002}, {1e-7, 1, -2e-7}});
  REQUIRE(found.size() == 2);
  CHECK(found[0].t == 1);
  CHECK(found[1].t == 1001);
  CHECK(found[1].part == top_part);
}

TEST_CASE("cylinder: a slanted ray that all but touches it keeps both crossings apart") {
  CHECK(near(distances(between({0, 0, 0}, {0, 4, 0}, 1), {{1 - 0x1p-30, -1, -3}, {0, 0.5, 1}}),
             {2.9999568416271348931, 3.0000431583728651069}, 1e-11));
}

TEST_CASE("cylinder: as a solid") {
  CHECK(is_solid(standing));
  CHECK(is_solid(endless({0, 1, 0}, 1)));
  CHECK_FALSE(is_solid(tube));
  CHECK(near(span(standing, {{-3, 1, 0}, {0.5, 0, 0}}), {4, 8}));
  CHECK(near(span(standing, {{3, 1, 0}, {1, 0, 0}}), {-4, -2}));
  CHECK(near(span(standing, {{0.5, -1, 0}, {0, 1, 0}}), {1, 3}));
  CHECK(span(standing, {{-3, 2.5, 0}, {1, 0, 0}}).empty());
  const std::vector<double> everywhere{-std::numeric_limits<double>::infinity(),
                                       std::numeric_limits<double>::infinity()};
  CHECK(span(endless({0, 1, 0}, 1), {{0.5, 0, 0}, {0, 1, 0}}) == everywhere);
  CHECK(contains(standing, {0.7, 0.1, 0.7}));
  CHECK_FALSE(contains(standing, {0.8, 0.1, 0.8}));
  CHECK_FALSE(contains(standing, {0, 2.1, 0}));
  CHECK(contains(endless({0, 1, 0}, 1), {0, 1e9, 0}));
}

TEST_CASE("cylinder: similar maps place it, others do not") {
  const auto moved =
      placed(standing, Affine::translating({5, 0, 0}) * Affine::rotating({0, 0, 1}, -90) * Affine::scaling({2, 2, 2}));
  REQUIRE(moved); // from (5, 0, 0) to (9, 0, 0), radius 2
  CHECK(near(distances(*moved, {{0, 1, 0}, {1, 0, 0}}), {5, 9}));
  CHECK(near(distances(*moved, {{6, 5, 0}, {0, -1, 0}}), {3, 7}));
  CHECK_FALSE(placed(standing, Affine::scaling({1, 2, 1})));
}

TEST_CASE("cylinder: its box is tight under rotation, and endless only along an endless axis") {
  // Turned by 45° about z: the ends' discs reach cos 45° about their centres in x and y.
  const double s = std::sqrt(0.5);
  const Box3 box = bounds(standing, Affine::rotating({0, 0, 1}, 45));
  CHECK(near(box.lower, {-2 * s - s, -s, -1}));
  CHECK(near(box.upper, {s, 2 * s + s, 1}));
  const Box3 column = bounds(endless({0, 1, 0}, 2), Affine::translating({1, 0, 0}));
  CHECK(column.lower == Vec3{-1, -std::numeric_limits<double>::infinity(), -2});
  CHECK(column.upper == Vec3{3, std::numeric_limits<double>::infinity(), 2});
}

// The line's point nearest to the axis is made at a chosen distance from it, in a direction m across the axis; the line
// runs there across m, under an angle to the axis.
TEST_CASE("cylinder: only lines that miss its side are told to pass by") {
  Random random(21);
  int nearly_touching = 0, told = 0, apart = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double size = random.magnitude(1e-6, 1e6);
    const Vec3 axis = random.direction();
    CylinderGeometry cylinder{random.step(1e-3, 1e3) * size, axis, size * random.magnitude(1e-2, 1e2), size};
    cylinder.extent = CylinderGeometry::Extent::infinite;
    const Vec3 m = normalize(cross(axis, random.direction())), across = cross(axis, m);
    const double slope = random.magnitude(1e-7, 1), far = random.magnitude(1e-2, 1e8);
    const double distance = i % 2 == 0 ? 1 - random.magnitude(1e-7, 1) : 1 + random.magnitude(1e-2, 10);
    const Vec3 nearest = cylinder.base + axis * (random.between(0, 1) * cylinder.height) + m * (distance * size);
    const Vec3 direction = normalize(axis * std::sqrt(1 - slope * slope) + across * slope);
    const Ray ray{nearest - direction * (far * size), direction * random.magnitude(1e-3, 1e3)};
    // What the origin was rounded by must not carry the line out of the side.
    const double margin = 1e-15 * (length(ray.origin) + length(cylinder.base)) / size;
    if (distance + margin < 1) {
      REQUIRE_FALSE(passes_by(cylinder, ray));
      nearly_touching += distance > 0.999;
    } else if (distance > 1.01 && slope > 1e-3 && far < 1e6) {
      told += passes_by(cylinder, ray), ++apart;
    }
  }
  CHECK(nearly_touching > 5000);
  CHECK(told == apart);
  CHECK(apart > 5000);
}
