#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

using Path = std::vector<std::uint32_t>;

Path path(Asked& asked, const Vec3& origin, const Vec3& direction) {
  return asked.compiled.path(asked.nearest(origin, direction));
}

} // namespace

TEST_CASE("compile: an empty scene is hit by nothing") {
  Asked asked{SceneBuilder()};
  CHECK_FALSE(asked.nearest({0, 0, 0}, {1, 2, 3}));
  CHECK(asked.transmittance({0, 0, 0}, {1, 2, 3}) == white);
  CHECK(asked.all({0, 0, 0}, {0, 0, 1}).empty());
  CHECK(asked.compiled.around({0, 0, 0}).empty());
}

TEST_CASE("compile: planes alone need no tree") {
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, -1));
  k.add(k.plane({0, 1, 0}, -2));
  Asked asked(k);
  CHECK(asked.nearest({0, 0, 0}, {0, -1, 0}).t == 1);
  CHECK(asked.all({0, 0, 0}, {0, -1, 0}) == std::vector<double>{1, 2});
  CHECK_FALSE(asked.nearest({0, 0, 0}, {0, 1, 0}));
}

TEST_CASE("compile: equal distances go to the object declared first, whatever its kind") {
  // All of them meet the ray from above at height 1.
  for (int first = 0; first < 4; ++first) {
    SceneBuilder k;
    std::vector<scene::Object> things;
    things.push_back(k.sphere());
    things.push_back(k.plane({0, 1, 0}, 1));
    things.push_back(k.box({-1, -1, -1}, {1, 1, 1}));
    scene::Disc disc;
    things.push_back(k.shape(disc).at({0, 1, 0}));
    std::rotate(things.begin(), things.begin() + first, things.end());
    for (const scene::Object& thing : things) k.add(thing);
    Asked asked(k);
    CHECK(asked.nearest({0, 5, 0}, {0, -1, 0}).t == 4);
    CHECK(path(asked, {0, 5, 0}, {0, -1, 0}) == Path{0});
    CHECK(asked.surface({0, 5, 0}, {0, -1, 0}).order == 0);
  }
}

TEST_CASE("compile: among many equal ones the first is hit") {
  SceneBuilder k;
  for (int i = 0; i < 100; ++i) k.add(k.sphere().at({0, 0, 1.0 * (i % 10)}));
  Asked asked(k);
  CHECK(path(asked, {0, 0, -5}, {0, 0, 1}) == Path{0});
  CHECK(path(asked, {5, 0, 3}, {-1, 0, 0}) == Path{3});
}

TEST_CASE("compile: what is invisible is absent, alone, in a group and as an operand") {
  SceneBuilder k;
  k.add(k.sphere(3).invisible());
  k.add(k.group({k.sphere(2)}).invisible());
  k.add(k.subtract({k.sphere(1), k.sphere(0.5).at({0, 0, 1}).invisible()}));
  Asked asked(k);
  CHECK(asked.nearest({0, 0, 5}, {0, 0, -1}).t == 4);
  CHECK(path(asked, {0, 0, 5}, {0, 0, -1}) == Path{2, 0});
}

TEST_CASE("compile: a turned sphere is an ellipsoid") {
  SceneBuilder k;
  k.add(k.sphere().transformed(k.scaled({1, 2, 4})).at({0, 0, 10}));
  Asked asked(k);
  CHECK(asked.nearest({0, 0, 0}, {0, 0, 1}).t == 6);
  CHECK(asked.nearest({0, 9, 10}, {0, -1, 0}).t == 7);
  const Surface s = asked.surface({0, 0, 0}, {0, 0, 1});
  CHECK(s.normal.z == -1);
  CHECK(s.position.z == Approx(6).epsilon(1e-15));
}

TEST_CASE("compile: paths lead through groups, also those that are taken apart") {
  SceneBuilder k;
  k.add(k.sphere().at({-10, 0, 0}));
  k.add(k.group({k.sphere().at({0, 0, 0}), k.group({k.sphere().invisible(), k.sphere().at({4, 0, 0})}),
                 k.sphere().at({8, 0, 0})}));
  k.add(k.sphere().at({12, 0, 0}));
  Asked asked(k);
  CHECK(path(asked, {-10, 0, 5}, {0, 0, -1}) == Path{0});
  CHECK(path(asked, {0, 0, 5}, {0, 0, -1}) == Path{1, 0});
  CHECK(path(asked, {4, 0, 5}, {0, 0, -1}) == Path{1, 1, 1});
  CHECK(path(asked, {8, 0, 5}, {0, 0, -1}) == Path{1, 2});
  CHECK(path(asked, {12, 0, 5}, {0, 0, -1}) == Path{2});
  // The invisible one does not count in the order.
  CHECK(asked.surface({12, 0, 5}, {0, 0, -1}).order == 4);
}

TEST_CASE("compile: an origin far away sees small things where they are") {
  SceneBuilder k;
  for (int i = 0; i < 10; ++i) k.add(k.sphere(0.25).at({1.0 * i, 0, 0}));
  Asked asked(k);
  // From a distance of 2^20 the direction to the fourth sphere is exact.
  CHECK(asked.nearest({3, 0, 1048576}, {0, 0, -1}).t == 1048576 - 0.25);
  CHECK(path(asked, {3, 0, 1048576}, {0, 0, -1}) == Path{3});
  CHECK_FALSE(asked.nearest({3.5, 0, 1048576}, {0, 0, -1}));
}

TEST_CASE("compile: a scene far from the origin loses nothing") {
  SceneBuilder k;
  for (int i = 0; i < 10; ++i) k.add(k.sphere(0.25).at({1048576.0 + i, 1048576, 0}));
  Asked asked(k);
  CHECK(asked.nearest({1048579, 1048576, 5}, {0, 0, -1}).t == 4.75);
  CHECK_FALSE(asked.nearest({1048579.5, 1048576, 5}, {0, 0, -1}));
}

TEST_CASE("compile: tiny and huge scenes are as good as others") {
  for (const double scale : {1e-30, 1e-10, 1.0, 1e10, 1e30}) {
    SceneBuilder k;
    for (int i = 0; i < 10; ++i) k.add(k.sphere(0.25 * scale).at({i * scale, 0, 0}));
    Asked asked(k);
    CHECK(asked.nearest({3 * scale, 0, 5 * scale}, {0, 0, -1}).t == Approx(4.75 * scale).epsilon(1e-14));
    CHECK_FALSE(asked.nearest({3.5 * scale, 0, 5 * scale}, {0, 0, -1}));
  }
}

TEST_CASE("compile: t counts lengths of a direction that is no unit vector") {
  SceneBuilder k;
  for (int i = 0; i < 10; ++i) k.add(k.sphere(0.25).at({1.0 * i, 0, 0}));
  Asked asked(k);
  CHECK(asked.nearest({3, 0, 5}, {0, 0, -0.5}).t == 9.5);
  CHECK(asked.nearest({3, 0, 5}, {0, 0, -1e12}).t == Approx(4.75e-12).epsilon(1e-14));
}
