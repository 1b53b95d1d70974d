// Parts of one solid whose faces lie in each other: a hole that is cut flush with the surface, a lid in its opening.
// Each part is turned by an angle of its own about an axis that leaves its faces where they are, so that the parts'
// distances along a ray differ by rounding.

#include "tests/support/asked.hpp"
#include "tests/support/placements.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::tests;

namespace {

Thing upright(SceneBuilder& k, double from, double to, double radius) {
  scene::Cylinder c;
  c.from = {0, from, 0}, c.to = {0, to, 0}, c.radius = radius;
  return k.shape(c);
}

scene::TransformId turned(SceneBuilder& k, SplitMix64& random) {
  return k.rotated({0, random.between(-180, 180), 0});
}

// A block from y = 0 to y = 1, 2√2 or less in diameter.
scene::Object block(SceneBuilder& k, SplitMix64& random, scene::MaterialId material = scene::no_material) {
  return k.box({-1, 0, -1}, {1, 1, 1}).with(material).transformed(turned(k, random));
}

scene::Object cutter(SceneBuilder& k, SplitMix64& random, double from, double to,
                     scene::MaterialId material = scene::no_material) {
  return upright(k, from, to, 0.6).with(material).transformed(turned(k, random));
}

Vec3 within_hole(SplitMix64& random, double y) {
  return {random.between(-0.4, 0.4), y, random.between(-0.4, 0.4)};
}

} // namespace

TEST_CASE("solids: a hole that is cut flush with the surface has no skin over it, for eyes and for light") {
  SplitMix64 random(1401);
  for (const double scale : {1.0, 1e-9, 1e9, 0.01}) {
    for (int i = 0; i < 25; ++i) {
      SceneBuilder k;
      const scene::Placement placement = anywhere(random, scale);
      place(k, {k.subtract({block(k, random), cutter(k, random, 0.25, 1)})}, placement);
      Asked asked(k);
      const Affine map = matrix(placement);
      for (int n = 0; n < 20; ++n) {
        const Vec3 above = within_hole(random, 3), below = within_hole(random, 0.3);
        // The ground of the hole at y = 0.25 and the block's at y = 0, 2.75 and 3 below.
        const Ray ray = carried(placement, above, {0, -1, 0});
        const auto ts = asked.all(ray.origin, ray.direction);
        REQUIRE(ts.size() == 2);
        REQUIRE(ts[0] / scale == Approx(2.75).epsilon(1e-12));
        REQUIRE(ts[1] / scale == Approx(3).epsilon(1e-12));
        REQUIRE(asked.transmittance(map.point(below), map.point(above)) == white);
        REQUIRE(asked.transmittance(map.point(above), map.point(below)) == white);
      }
    }
  }
}

TEST_CASE("solids: a hole right through, flush on both sides, is open") {
  SplitMix64 random(1402);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k, {k.subtract({block(k, random), cutter(k, random, 0, 1)})}, placement);
    Asked asked(k);
    const Affine map = matrix(placement);
    for (int n = 0; n < 20; ++n) {
      const Vec3 from = map.point(within_hole(random, 2)), to = map.point(within_hole(random, -2));
      REQUIRE(asked.all(from, to - from).empty());
      REQUIRE(asked.transmittance(from, to) == white);
    }
  }
}

TEST_CASE("solids: a skin that is thicker than rounding is there") {
  SplitMix64 random(1403);
  for (int i = 0; i < 40; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1, 1);
    place(k, {k.subtract({block(k, random), cutter(k, random, 0.25, 1 - 1e-12)})}, placement);
    Asked asked(k);
    const Ray ray = carried(placement, within_hole(random, 3), {0, -1, 0});
    REQUIRE(asked.all(ray.origin, ray.direction).size() == 4);
  }
}

TEST_CASE("solids: of parts whose faces touch the one declared first shows, whatever rounding says") {
  SplitMix64 random(1404);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    const scene::Object lid = cutter(k, random, 0.5, 1, k.glow(0.75)), around = block(k, random, k.glow(0.25));
    const bool lid_first = i % 2 == 0;
    place(k, {lid_first ? k.unite({lid, around}) : k.unite({around, lid})}, placement);
    Asked asked(k);
    for (int n = 0; n < 20; ++n) {
      const Ray ray = carried(placement, within_hole(random, 3), {0, -1, 0});
      REQUIRE(asked.radiance(ray.origin, ray.direction) == grey(lid_first ? 0.75 : 0.25));
    }
  }
}

TEST_CASE("solids: what is left where two parts share a face and no more is nothing") {
  SplitMix64 random(1405);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k, {k.intersect({block(k, random), cutter(k, random, 1, 2)})}, placement);
    Asked asked(k);
    for (int n = 0; n < 20; ++n) {
      const Ray ray = carried(placement, within_hole(random, 3), {0, -1, 0});
      REQUIRE(asked.all(ray.origin, ray.direction).empty());
    }
  }
}

TEST_CASE("solids: clear parts that share a face filter light at the outside of the whole alone") {
  SplitMix64 random(1406);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k, {k.unite({block(k, random), upright(k, 1, 2, 1).transformed(turned(k, random))}).with(k.clear(1.5, 0.5))},
          placement);
    Asked asked(k);
    const Affine map = matrix(placement);
    for (int n = 0; n < 20; ++n) // half of it at y = 2, and half of that at y = 0
      REQUIRE(asked.transmittance(map.point(within_hole(random, 3)), map.point(within_hole(random, -1))) == grey(0.25));
  }
}
