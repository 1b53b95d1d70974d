#include "renderer/shapes/box.hpp"
#include "tests/support/shapes.hpp"

using namespace rt;
using namespace rt::tests;

namespace {
const BoxGeometry box{{-1, -2, -3}, {1, 2, 3}};
}

TEST_CASE("box: a ray enters through one face and leaves through another") {
  // x = −1 at t = 2 (y = 1), y = 2 at t = 3 (x = 0)
  const Ray ray{{-3, -1, 0.5}, {1, 1, 0}};
  const auto found = hits(box, ray);
  REQUIRE(found.size() == 2);
  CHECK(found[0].t == 2);
  CHECK(found[1].t == 3);
  const SurfacePoint in = surface_point(box, ray, found[0]), out = surface_point(box, ray, found[1]);
  CHECK(in.position == Vec3{-1, 1, 0.5});
  CHECK(in.normal == Vec3{-1, 0, 0});
  CHECK(out.position == Vec3{0, 2, 0.5});
  CHECK(out.normal == Vec3{0, 1, 0});
}

TEST_CASE("box: each face has its outward normal") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3 origin, direction, normal;
      origin[axis] = 10 * sign, direction[axis] = -2 * sign, normal[axis] = sign;
      const SurfacePoint point = first_point(box, {origin, direction});
      CHECK(point.normal == normal);
      CHECK(point.position[axis] == sign * static_cast<double>(axis + 1));
    }
  }
}

TEST_CASE("box: misses, hits from inside, and what lies behind") {
  CHECK(distances(box, {{-3, 0, 0}, {1, 2, 0}}).empty());
  CHECK(distances(box, {{3, 0, 0}, {1, 0, 0}}).empty());
  CHECK(distances(box, {{-3, 2.5, 0}, {1, 0, 0}}).empty());
  CHECK(distances(box, {{0, 0, 0}, {0.5, 0, 0}}) == std::vector<double>{2});
  CHECK(distances(box, {{0, 0, 0}, {-0.0, -0.0, -1}}) == std::vector<double>{3});
}

TEST_CASE("box: a ray within a face's plane meets the faces it runs into") {
  CHECK(distances(box, {{-3, 2, 0}, {1, 0, 0}}) == std::vector<double>{2, 4});
  CHECK(distances(box, {{-3, 2, 3}, {1, -0.0, 0}}) == std::vector<double>{2, 4}); // along an edge
  CHECK(distances(box, {{-3, 2 + 1e-15, 0}, {1, 0, 0}}).empty());
}

TEST_CASE("box: through a corner and through an edge") {
  CHECK(distances(BoxGeometry{{0, 0, 0}, {1, 1, 1}}, {{-1, -1, -1}, {1, 1, 1}}) == std::vector<double>{1, 2});
  CHECK(distances(BoxGeometry{{0, 0, 0}, {1, 1, 1}}, {{-1, 1, 0.5}, {1, 0, 0}}) == std::vector<double>{1, 2});
  // Touching an edge is meeting it once.
  CHECK(distances(BoxGeometry{{0, 0, 0}, {1, 1, 1}}, {{-1, 1, 0.5}, {1, -1, 0}}) == std::vector<double>{1});
}

TEST_CASE("box: far, tiny and huge") {
  const BoxGeometry tiny{{1e6, 0, 0}, {1e6 + 0x1p-20, 0x1p-20, 0x1p-20}};
  CHECK(distances(tiny, {{0, 0x1p-21, 0x1p-21}, {0.5, 0, 0}}) == std::vector<double>{2e6, 2e6 + 0x1p-19});
  const BoxGeometry huge{{-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}};
  CHECK(distances(huge, {{1, 1, 1}, {0, 0, 8}}) == std::vector<double>{(1e6 - 1) / 8});
}

TEST_CASE("box: size, and corners in any order") {
  scene::Box raw;
  CHECK(geometry(raw).lower == Vec3{-0.5, -0.5, -0.5});
  raw.size = Vec3{2, 4, 6};
  CHECK(geometry(raw).lower == box.lower);
  CHECK(geometry(raw).upper == box.upper);
  scene::Box corners;
  corners.from = Vec3{1, -2, 3}, corners.to = Vec3{-1, 2, -3};
  CHECK(geometry(corners).lower == box.lower);
  CHECK(geometry(corners).upper == box.upper);
}

TEST_CASE("box: as a solid") {
  CHECK(span(box, {{-3, 0, 0}, {1, 0, 0}}) == std::vector<double>{2, 4});
  CHECK(span(box, {{5, 0, 0}, {1, 0, 0}}) == std::vector<double>{-6, -4});
  CHECK(span(box, {{5, 5, 0}, {1, 0, 0}}).empty());
  CHECK(span(BoxGeometry{{0, 0, 0}, {1, 1, 1}}, {{-1, 1, 0.5}, {1, 1, 0}}).empty());
  CHECK(contains(box, {0.9, 1.9, -2.9}));
  CHECK_FALSE(contains(box, {1, 0, 0}));
}

TEST_CASE("box: maps along the axes place it, others do not") {
  const auto moved = placed(box, Affine::translating({5, 0, 0}) * Affine::scaling({-2, 1, 1}));
  REQUIRE(moved);
  CHECK(moved->lower == Vec3{3, -2, -3});
  CHECK(moved->upper == Vec3{7, 2, 3});
  CHECK_FALSE(placed(box, Affine::rotating({0, 0, 1}, 30)));
  const Box3 around = bounds(box, Affine::rotating({0, 0, 1}, 90));
  CHECK(around.lower == Vec3{-2, -1, -3});
  CHECK(around.upper == Vec3{2, 1, 3});
}
