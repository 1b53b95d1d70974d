// Surfaces that touch, turned, scaled and moved about at random. Expectations are Snell's and Fresnel's laws.

#include "tests/renderer/integrators/followed.hpp"
#include "tests/support/placements.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

using namespace rt;
using namespace rt::tests;

namespace {

const double pi = 3.14159265358979323846;
const Vec3 down{0, -1, 0};

} // namespace

TEST_CASE("contact: a clear block that stands on a floor shows the floor everywhere") {
  SplitMix64 random(1301);
  for (const double scale : {1.0, 1e-9, 1e9, 1e-3, 137.0}) {
    for (int i = 0; i < 40; ++i) {
      SceneBuilder k;
      const auto glass = k.clear(1.5), floor = k.glow(0.5);
      std::vector<scene::Object> things{k.box({-9, 0, -9}, {9, 1, 9}).with(glass), k.plane({0, 1, 0}, 0).with(floor)};
      shuffle(things, random);
      const scene::Placement placement = anywhere(random, scale);
      place(k, things, placement);
      Asked asked(k);
      for (int n = 0; n < 50; ++n) {
        const Vec3 from{random.between(-4, 4), 4, random.between(-4, 4)};
        const Vec3 to{random.between(-4, 4), 1, random.between(-4, 4)};
        const Ray ray = carried(placement, from, to - from);
        REQUIRE(asked.radiance(ray.origin, ray.direction) == grey(0.5));
      }
    }
  }
}

TEST_CASE("contact: the floor is seen through a block over it however small the gap") {
  SplitMix64 random(1312);
  for (int i = 0; i < 300; ++i) {
    SceneBuilder k;
    const double gap = std::pow(10, random.between(-18, -8)) * (i % 3 == 0 ? -1 : 1);
    const scene::Placement placement = anywhere(random, 1);
    std::vector<scene::Object> things{k.box({-9, gap, -9}, {9, 1, 9}).with(k.clear(1.5)),
                                      k.plane({0, 1, 0}, 0).with(k.glow(0.5))};
    shuffle(things, random);
    place(k, things, placement);
    Asked asked(k);
    for (int n = 0; n < 20; ++n) {
      const Ray ray = carried(placement, {random.between(-4, 4), 4, 0}, {random.between(-0.5, 0.5), -1, 0.2});
      REQUIRE(asked.radiance(ray.origin, ray.direction) == grey(0.5));
    }
  }
}

TEST_CASE(
    "contact: a floor that is lit through the block that stands on it is filtered by the block's other side alone") {
  SplitMix64 random(1302);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    scene::Material half = clear_material(1, false);
    half.refract = 0.5;
    scene::Material white_matte;
    white_matte.diffuse = grey(1);
    std::vector<scene::Object> things{k.box({-9, 0, -9}, {9, 1, 9}).with(k.material(half)),
                                      k.plane({0, 1, 0}, 0).with(k.material(white_matte))};
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, 1);
    place(k, things, placement);
    k.sun(matrix(placement).vector(down));
    const Ray ray = carried(placement, {0.3, 4, 0.2}, {0.1, -1, 0.2});
    // The block's top lets half of the light in and half of it out; its own diffuse colour is 0.
    CHECK(seen(k, ray).r == Approx(0.25).epsilon(1e-9));
  }
}

TEST_CASE("contact: of opaque surfaces in one place the one declared first is seen") {
  SplitMix64 random(1303);
  for (int i = 0; i < 100; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k, {k.box({-1, -1, -1}, {1, 0, 1}).with(k.glow(0.25)), k.plane({0, 1, 0}, 0).with(k.glow(0.75))}, placement);
    CHECK(seen(k, carried(placement, {random.between(-0.9, 0.9), 4, random.between(-0.9, 0.9)}, down)) == grey(0.25));
  }
}

TEST_CASE(
    "contact: light through a plate on water leaves where Snell's law says, in whatever order they are declared") {
  SplitMix64 random(1304);
  const double sine = std::sqrt(0.5);
  const auto shift = [&](double ior, double thickness) { return thickness * std::tan(std::asin(sine / ior)); };
  for (const double scale : {1.0, 1e-9, 1e9}) {
    for (int i = 0; i < 50; ++i) {
      SceneBuilder k;
      auto things = pile(k, {{1.52, 1}, {1.333, 2}}, false);
      if (i % 2 == 1) std::swap(things[0], things[1]);
      const scene::Placement placement = anywhere(random, scale);
      place(k, things, placement);
      const Way way = follow(k, carried(placement, {-3, 3, 0}, {1, -1, 0}));
      const Affine back = inverse(matrix(placement)).value();
      const Vec3 end = back.point(way.last.origin), direction = normalize(back.vector(way.last.direction));
      CHECK(way.bends == 3);
      CHECK(length(end - Vec3{shift(1.52, 1) + shift(1.333, 2), -3, 0}) < 1e-12);
      CHECK(length(direction - Vec3{sine, -sine, 0}) < 1e-12);
    }
  }
}

TEST_CASE("contact: piles of touching plates bend and mirror at one boundary between each and the next") {
  SplitMix64 random(1305);
  for (int i = 0; i < 150; ++i) {
    std::vector<Plate> plates(2 + random.bits() % 4);
    for (Plate& p : plates) p = {random.between(1.1, 2.4), random.between(0.1, 2)};
    SceneBuilder k;
    k.scene.max_depth = 12;
    auto things = pile(k, plates, true);
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, std::pow(10, random.between(-6, 6)));
    place(k, things, placement);

    const double sine = random.between(0, 0.95), tangent = sine / std::sqrt(1 - sine * sine);
    const Way way = follow(k, carried(placement, {-tangent, 1, 0}, {tangent, -1, 0}));
    double x = 0, y = 0, ior = 1, transmitted = 1;
    for (const Plate& p : plates) {
      transmitted *= 1 - reflectance(ior, p.ior, sine / ior);
      ior = p.ior;
      x += p.thickness * std::tan(std::asin(sine / ior)), y -= p.thickness;
    }
    transmitted *= 1 - reflectance(ior, 1, sine / ior);
    const Vec3 end = inverse(matrix(placement)).value().point(way.last.origin);
    REQUIRE(way.bends == static_cast<int>(plates.size()) + 1);
    REQUIRE(length(end - Vec3{x, y, 0}) < 1e-10);
    REQUIRE(way.weight.r == Approx(transmitted).epsilon(1e-9));
    REQUIRE(way.most_touching == 2);
  }
}

TEST_CASE("contact: beyond the critical angle of two media that touch all light is mirrored, whatever air would do") {
  // From glass to water at 65°: the critical angle is asin(1.333/1.52) = 61.3°; to air it would be 41.1°.
  for (const double degrees : {55.0, 65.0}) {
    SceneBuilder k;
    k.scene.background = grey(0.25);
    place(k, pile(k, {{1.52, 3}, {1.333, 3}}, false), {});
    k.add(k.plane({0, 1, 0}, -5).with(k.glow(1)));
    const double angle = degrees * pi / 180;
    const Way way = follow(k, {{0, -1, 0}, {std::sin(angle), -std::cos(angle), 0}});
    CHECK(way.bends == (degrees < 61.3 ? 1 : 0));
  }
}

TEST_CASE("contact: ice in water, flush with its surface or in a hole of its shape, bends light as ice") {
  SplitMix64 random(1308);
  const double sine = 0.6, water = 1.333, ice = 1.31;
  for (int i = 0; i < 80; ++i) {
    for (const bool has_hole : {false, true}) {
      SceneBuilder k;
      const auto block = [&] { return k.box({-2, -1, -2}, {2, 0, 2}); };
      const auto pond = k.material(clear_material(water, true));
      scene::Object around = has_hole ? k.subtract({k.box({-20, -4, -20}, {20, 0, 20}), block()}).with(pond)
                                      : k.box({-20, -4, -20}, {20, 0, 20}).with(pond);
      std::vector<scene::Object> things{around, block().with(k.material(clear_material(ice, true)))};
      shuffle(things, random);
      const scene::Placement placement = anywhere(random, 1);
      place(k, things, placement);
      const Way way = follow(k, carried(placement, {-0.75, 1, 0}, {0.75, -1, 0}));
      const double x = std::tan(std::asin(sine / ice)) + 3 * std::tan(std::asin(sine / water));
      CHECK(length(inverse(matrix(placement)).value().point(way.last.origin) - Vec3{x, -4, 0}) < 1e-12);
      // One boundary at the top, from air to ice.
      const double top = 1 - reflectance(1, ice, sine), bottom = 1 - reflectance(water, 1, sine / water);
      if (has_hole)
        CHECK(way.weight.r == Approx(top * (1 - reflectance(ice, water, sine / ice)) * bottom).epsilon(1e-9));
      else
        CHECK(way.weight.r == Approx(top * bottom).epsilon(1e-9)); // nothing is mirrored within a solid: POV-Ray's rule
      CHECK(way.bends == 3);

      // And from below.
      const double up = 3 * std::tan(std::asin(sine / water)), far = up + std::tan(std::asin(sine / ice));
      const Way back = follow(k, carried(placement, {-0.75 - up, -5, 0}, {0.75, 1, 0}));
      CHECK(back.bends == 3);
      CHECK(length(inverse(matrix(placement)).value().point(back.last.origin) - Vec3{far - up, 0, 0}) < 1e-12);
    }
  }
}

TEST_CASE("contact: of solids that begin in one face and overlap in part the denser one bends light, however they are "
          "turned") {
  SplitMix64 random(1315);
  const double sine = 0.6;
  for (int i = 0; i < 100; ++i) {
    SceneBuilder k;
    std::vector<scene::Object> things{k.box({-9, -1, -5}, {random.between(1, 4), 0, 5}).with(k.clear(1.3)),
                                      k.box({random.between(-4, -1), -1, -3}, {9, 0, 7}).with(k.clear(1.5))};
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, 1);
    place(k, things, placement);
    const Way way = follow(k, carried(placement, {-0.75, 1, 0}, {0.75, -1, 0}));
    REQUIRE(way.bends == 2);
    const Vec3 end = inverse(matrix(placement)).value().point(way.last.origin);
    REQUIRE(length(end - Vec3{std::tan(std::asin(sine / 1.5)), -1, 0}) < 1e-12);
  }
}

TEST_CASE("contact: a ball that fills a hollow one to its wall leads to a boundary between the two") {
  SplitMix64 random(1309);
  for (int i = 0; i < 60; ++i) {
    SceneBuilder k;
    std::vector<scene::Object> things{k.subtract({k.sphere(2), k.sphere(1)}).with(k.clear(1.5)),
                                      k.sphere(1).with(k.clear(1.2))};
    shuffle(things, random);
    const scene::Placement placement = anywhere(random, std::pow(10, random.between(-9, 9)));
    place(k, things, placement);
    const double impact = random.between(-0.9, 0.9);
    const Way way = follow(k, carried(placement, {impact, 5, 0}, down));
    // Bouguer: n·r·sin θ is the impact parameter everywhere. The ray turns by 2(i − t) at the outer sphere, and by
    // 2(i′ − t′) at the inner one.
    const double turn =
        2 * (std::asin(impact / 2) - std::asin(impact / 3) + std::asin(impact / 1.5) - std::asin(impact / 1.2));
    const Vec3 direction = normalize(inverse(matrix(placement)).value().vector(way.last.direction));
    REQUIRE(way.bends == 4);
    REQUIRE(length(direction - Vec3{-std::sin(turn), -std::cos(turn), 0}) < 1e-9);
  }
}

TEST_CASE("contact: parts of one clear solid that touch have no seam") {
  SplitMix64 random(1310);
  for (int i = 0; i < 100; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1);
    place(k,
          {k.unite({k.box({-9, -1, -9}, {9, 0, 9}), k.box({-9, -2, -9}, {9, -1, 9})})
               .with(k.material(clear_material(1.5, true)))},
          placement);
    const Way way = follow(k, carried(placement, {0.1, 2, 0.3}, {0.4, -1, 0.2}));
    CHECK(way.bends == 2);
    CHECK(way.surfaces == 2);
  }
}

TEST_CASE(
    "contact: surfaces apart by more than rounding are met one by one, in order, though their distances are equal") {
  SplitMix64 random(1311);
  // From 1e5 away the distance along the ray is known to 1e-11 only; the order of the surfaces is known all the same.
  for (int i = 0; i < 200; ++i) {
    SceneBuilder k;
    const scene::Placement placement = anywhere(random, 1, 0);
    place(k, {k.plane({0, 1, 0}, 0).with(k.glow(0.25)), k.plane({0, 1, 0}, 1e-12).with(k.glow(0.75))}, placement);
    CHECK(seen(k, carried(placement, {random.between(-1, 1), 1e5, random.between(-1, 1)}, {3e-6, -1, 2e-6})) ==
          grey(0.75));
  }
}
