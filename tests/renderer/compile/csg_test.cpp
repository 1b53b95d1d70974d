#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

using Path = std::vector<std::uint32_t>;
using Ts = std::vector<double>;

Vec3 normal(Asked& asked, const Vec3& origin, const Vec3& direction) {
  return asked.surface(origin, direction).normal;
}

} // namespace

TEST_CASE("solids: a union of overlapping spheres keeps its outer boundary only") {
  SceneBuilder k;
  // From −1 to 1 and from 0 to 2.
  k.add(k.unite({k.sphere(), k.sphere().at({0, 0, 1})}));
  Asked asked(k);
  CHECK(asked.all({0, 0, -5}, {0, 0, 1}) == Ts{4, 7});
  CHECK(asked.all({0, 0, 5}, {0, 0, -1}) == Ts{3, 6});
  CHECK(asked.compiled.path(asked.nearest({0, 0, -5}, {0, 0, 1})) == Path{0, 0});
  CHECK(asked.compiled.path(asked.nearest({0, 0, 5}, {0, 0, -1})) == Path{0, 1});
  // From within the overlap the way out leads through the other one's surface.
  CHECK(asked.all({0, 0, 0.5}, {0, 0, 1}) == Ts{1.5});
}

TEST_CASE("solids: an intersection is where all operands are") {
  SceneBuilder k;
  k.add(k.intersect({k.sphere(2), k.box({-1, -1, -5}, {1, 1, 1}), k.plane({0, 0, 1}, 0.5)}));
  Asked asked(k);
  // On the axis: the sphere from −2, the box to 1, the half-space to 0.5.
  CHECK(asked.all({0, 0, -5}, {0, 0, 1}) == Ts{3, 5.5});
  CHECK(normal(asked, {0, 0, 5}, {0, 0, -1}) == Vec3{0, 0, 1});
  CHECK(normal(asked, {0, 0, -5}, {0, 0, 1}) == Vec3{0, 0, -1});
  CHECK(asked.all({1.5, 0, -5}, {0, 0, 1}).empty());
}

TEST_CASE("solids: the cut face of a difference faces out of what is left, with the cutter's material") {
  SceneBuilder k;
  const auto red = k.glow({1, 0, 0}), green = k.glow({0, 1, 0});
  k.add(k.subtract({k.sphere(2).with(red), k.sphere(1).at({0, 0, -2}).with(green)}));
  Asked asked(k);
  // The cutter reaches to z = −1: there a hollow begins whose wall faces the ray.
  CHECK(asked.all({0, 0, -5}, {0, 0, 1}) == Ts{4, 7});
  CHECK(normal(asked, {0, 0, -5}, {0, 0, 1}) == Vec3{0, 0, -1});
  CHECK(asked.radiance({0, 0, -5}, {0, 0, 1}) == Color{0, 1, 0});
  CHECK(asked.radiance({0, 0, 5}, {0, 0, -1}) == Color{1, 0, 0});
  CHECK(asked.compiled.path(asked.nearest({0, 0, -5}, {0, 0, 1})) == Path{0, 1});
}

TEST_CASE("solids: a hole right through leaves two walls") {
  SceneBuilder k;
  k.add(k.subtract({k.sphere(2), k.sphere(1)}));
  Asked asked(k);
  CHECK(asked.all({0, 0, -5}, {0, 0, 1}) == Ts{3, 4, 6, 7});
  CHECK(asked.all({0, 0, 0}, {0, 0, 1}) == Ts{1, 2});
  CHECK(normal(asked, {0, 0, 0}, {0, 0, 1}) == Vec3{0, 0, -1}); // out of the shell: into the hollow
}

TEST_CASE("solids: a sphere and a half-space make a finite solid, half-spaces alone an infinite one") {
  SceneBuilder k;
  k.add(k.intersect({k.sphere(), k.plane({0, 1, 0}, 0)}));
  k.add(k.subtract({k.plane({0, 1, 0}, -4), k.plane({0, 1, 0}, -5)})); // a slab
  Asked asked(k);
  CHECK(asked.all({0, 5, 0}, {0, -1, 0}) == Ts{5, 6, 9, 10});
  CHECK(normal(asked, {0, 5, 0}, {0, -1, 0}) == Vec3{0, 1, 0});
  CHECK(normal(asked, {0, -10, 0}, {0, 1, 0}) == Vec3{0, -1, 0});
}

TEST_CASE("solids: a line that stays inside has no end") {
  SceneBuilder k;
  scene::Cylinder tube;
  tube.infinite = true;
  k.add(k.subtract({k.plane({0, 0, 1}, 0), k.shape(tube)})); // a half-space with half a shaft along y at its rim
  Asked asked(k);
  CHECK(asked.all({0, 0, 5}, {0, 0, -1}) == Ts{6});
  CHECK(asked.all({0, 0, -5}, {0, 1, 0}).empty());
  CHECK(asked.all({-3, 0, -0.5}, {1, 0, 0}).size() == 2);
}

TEST_CASE("solids: they nest, under any transform") {
  SceneBuilder k;
  // ((box − sphere) ∪ knob) turned by 90° about y, enlarged twice and moved.
  const auto turn = k.transform({.scale = {2, 2, 2}, .rotate = {0, 90, 0}, .at = {}, .chain = {}});
  k.add(k.unite({k.subtract({k.box({-1, -1, -1}, {1, 1, 1}), k.sphere(0.5).at({0, 0, 1})}),
                 k.sphere(0.25).at({0, 0, -1.25})})
            .transformed(turn)
            .at({10, 0, 0}));
  Asked asked(k);
  // Its own z axis lies along +x now: the dent is at 10 + 2 (1 − 0.5) = 11, the knob ends at 10 − 2 · 1.5 = 7.
  const auto ts = asked.all({0, 0, 0}, {1, 0, 0});
  REQUIRE(ts.size() == 2);
  CHECK(ts[0] == Approx(7).epsilon(1e-15));
  CHECK(ts[1] == Approx(11).epsilon(1e-15));
  CHECK(normal(asked, {20, 0, 0}, {-1, 0, 0}).x == Approx(1).epsilon(1e-15));
}

TEST_CASE("solids: a group or a list as an operand is the union of what it holds") {
  SceneBuilder k;
  k.add(k.subtract({k.box({-4, -1, -1}, {4, 1, 1}), k.group({k.sphere().at({-2, 0, 0}), k.sphere().at({2, 0, 0})})}));
  Asked asked(k);
  CHECK(asked.all({-9, 0, 0}, {1, 0, 0}) == Ts{5, 6, 8, 10, 12, 13});
  CHECK(asked.compiled.path(asked.nearest({0, 0, 0}, {1, 0, 0})) == Path{0, 1, 1});
}

TEST_CASE("solids: chains of differences and unions, with many operands, find the right ones") {
  SceneBuilder k;
  // A beam from 0 to 100 with a hole from i to i + ½ at each whole number below 100: subtracted one by one.
  scene::Object beam = k.box({0, -1, -1}, {100, 1, 1});
  for (int i = 0; i < 100; ++i) beam = k.subtract({beam, k.box({1.0 * i, -2, -2}, {i + 0.5, 2, 2})});
  k.add(beam);
  Asked asked(k);
  Ts expected;
  for (int i = 0; i < 100; ++i) expected.insert(expected.end(), {i + 1.5, i + 2.0});
  CHECK(asked.all({-1, 0, 0}, {1, 0, 0}) == expected);
  CHECK(asked.all({-1, 0.5, -9}, {0, 0, 1}).empty());
}

TEST_CASE("solids: parts that share a face unite without a wall between them") {
  SceneBuilder k;
  k.add(k.unite({k.box({0, 0, 0}, {1, 1, 1}), k.box({1, 0, 0}, {2, 1, 1})}));
  Asked asked(k);
  CHECK(asked.all({-1, 0.5, 0.5}, {1, 0, 0}) == Ts{1, 3});
  CHECK(asked.all({3, 0.5, 0.5}, {-1, 0, 0}) == Ts{1, 3});
}

TEST_CASE("solids: where surfaces coincide, the part declared first shows") {
  for (const bool swapped : {false, true}) {
    SceneBuilder k;
    const auto red = k.glow({1, 0, 0}), green = k.glow({0, 1, 0});
    const scene::Object a = k.box({-1, -1, -1}, {1, 1, 1}).with(red), b = k.box({-2, -2, -1}, {2, 2, 3}).with(green);
    k.add(swapped ? k.unite({b, a}) : k.unite({a, b}));
    Asked asked(k);
    CHECK(asked.radiance({0, 0, -5}, {0, 0, 1}) == (swapped ? Color{0, 1, 0} : Color{1, 0, 0}));
  }
}

TEST_CASE("solids: cutting away all of it leaves nothing, and so does an empty first operand") {
  SceneBuilder k;
  k.add(k.subtract({k.sphere(), k.sphere(2)}));
  k.add(k.subtract({k.group({}), k.sphere()}));
  k.add(k.subtract({k.sphere().invisible(), k.sphere()}));
  k.add(k.intersect({k.sphere(), k.sphere().at({5, 0, 0})}));
  Asked asked(k);
  CHECK(asked.all({0, 0, -5}, {0, 0, 1}).empty());
}

TEST_CASE("solids: parts inherit the material of the nearest composite that has one") {
  SceneBuilder k;
  const auto red = k.glow({1, 0, 0}), green = k.glow({0, 1, 0}), blue = k.glow({0, 0, 1});
  k.add(k.group({k.unite({k.sphere().at({-4, 0, 0}), k.sphere().at({0, 0, 0}).with(green),
                          k.group({k.sphere().at({4, 0, 0}), k.sphere().at({8, 0, 0}).with(red)}).with(blue)})})
            .with(red));
  Asked asked(k);
  CHECK(asked.radiance({-4, 0, 5}, {0, 0, -1}) == Color{1, 0, 0});
  CHECK(asked.radiance({0, 0, 5}, {0, 0, -1}) == Color{0, 1, 0});
  CHECK(asked.radiance({4, 0, 5}, {0, 0, -1}) == Color{0, 0, 1});
  CHECK(asked.radiance({8, 0, 5}, {0, 0, -1}) == Color{1, 0, 0});
}

TEST_CASE("solids: a solid that stands in two places is the same in both") {
  SceneBuilder k;
  const auto red = k.glow({1, 0, 0}), green = k.glow({0, 1, 0});
  const scene::Object dice =
      k.intersect({k.box({-1, -1, -1}, {1, 1, 1}), k.sphere(1.25).with(green)}).with(red).at({-5, 0, 0});
  k.add(dice);
  scene::Object other = dice;
  other.at = {5, 0, 0};
  other.transform = k.scaled({2, 1, 1});
  k.add(other);
  Asked asked(k);
  CHECK(asked.all({-10, 0, 0}, {1, 0, 0}) == Ts{4, 6, 13, 17});
  CHECK(asked.radiance({-10, 0, 0}, {1, 0, 0}) == Color{1, 0, 0});
  CHECK(asked.radiance({-5, 5, 5}, {0, -1, -1}) == Color{0, 1, 0}); // an edge, rounded off by the sphere
  CHECK(asked.compiled.path(asked.nearest({0, 0, 0}, {1, 0, 0})) == Path{1, 0});
}

TEST_CASE("solids: a part that casts no shadow lets light by, the rest does not") {
  SceneBuilder k;
  k.add(k.unite({k.sphere().at({-3, 0, 0}).without_shadow(), k.sphere().at({3, 0, 0})}));
  Asked asked(k);
  CHECK(asked.transmittance({-3, 0, -5}, {-3, 0, 5}) == white);
  CHECK(asked.transmittance({3, 0, -5}, {3, 0, 5}) == black);
}
