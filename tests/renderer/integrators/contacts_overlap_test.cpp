// Surfaces that touch, beside the same scenes with overlaps of 1e-7, where no two surfaces do.

#include "tests/renderer/integrators/followed.hpp"
#include "tests/support/placements.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace rt;
using namespace rt::tests;

TEST_CASE("contact: tinted, half mirrored plates that touch look as those that overlap by 1e-7") {
  SplitMix64 random(1306);
  for (int i = 0; i < 60; ++i) {
    std::vector<double> shades(8);
    for (double& s : shades) s = random.between(0.3, 1);
    const std::vector<Plate> plates{{random.between(1.1, 1.8), 1}, {random.between(1.1, 1.8), 0.7}, {1.2, 0.5}};
    const scene::Placement placement = anywhere(random, 1, 1);
    const Ray ray = carried(placement, {0.3, 2, 0.1}, {random.between(-1, 1), -1, random.between(-1, 1)});
    Color colors[2];
    for (const double overlap : {0.0, 1e-7}) {
      SceneBuilder k;
      k.scene.ambient = grey(0.2), k.scene.background = {0.1, 0.3, 0.8}, k.scene.max_depth = 7;
      auto things = pile(k, plates, false, overlap);
      for (std::size_t n = 0; n < things.size(); ++n) {
        scene::Material m;
        m.color = Color{shades[n], shades[n + 1], shades[n + 2]}, m.refract = 0.5 + shades[n] / 3,
        m.ior = plates[n].ior;
        m.reflect = grey(shades[n + 3] / 4), m.specular = 0.4, m.shininess = 20.0;
        things[n].material = k.material(m);
      }
      shuffle(things, random);
      place(k, things, placement);
      k.sun(matrix(placement).vector({0.3, -1, 0.2}));
      colors[overlap > 0] = seen(k, ray);
    }
    const Color off = colors[0] - colors[1];
    REQUIRE(max_component(colors[0]) > 0.05);
    REQUIRE(std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) < 1e-6);
  }
}

TEST_CASE("contact: with Fresnel's mirrors, plates that touch let by what overlapping ones do without a mirror of "
          "their own") {
  SplitMix64 random(1313);
  for (int i = 0; i < 100; ++i) {
    std::vector<Plate> plates(2 + random.bits() % 3);
    for (Plate& p : plates) p = {random.between(1.2, 1.8), random.between(0.3, 1)};
    const scene::Placement placement = anywhere(random, 1, 1);
    const double sine = random.between(0, 0.7), tangent = sine / std::sqrt(1 - sine * sine);
    const Ray ray = carried(placement, {-tangent, 1, 0}, {tangent, -1, 0});
    Way ways[2];
    for (const double overlap : {0.0, 1e-7}) {
      SceneBuilder k;
      k.scene.max_depth = 12;
      auto things = pile(k, plates, true, overlap);
      shuffle(things, random);
      place(k, things, placement);
      ways[overlap > 0] = follow(k, ray);
    }
    // Where plates overlap, the upper one's lower side is met within the lower one. By POV-Ray's rule nothing is bent
    // there, but light is mirrored as if the angle in the lower plate were one in the upper.
    double left = 1;
    for (std::size_t n = 1; n < plates.size(); ++n)
      left *= 1 - reflectance(plates[n - 1].ior, plates[n].ior, sine / plates[n].ior);
    REQUIRE(ways[1].weight.r == Approx(ways[0].weight.r * left).epsilon(1e-6));
    REQUIRE(length(ways[1].last.origin - ways[0].last.origin) < 1e-6);
  }
}

TEST_CASE("contact: blocks of one glass look the same side by side as where they overlap by 1e-7, all light followed") {
  SplitMix64 random(1314);
  for (int i = 0; i < 30; ++i) {
    const scene::Placement placement = anywhere(random, 1, 1);
    const Ray ray = carried(placement, {random.between(-1, 1), 4, random.between(-1, 1)},
                            {random.between(-0.7, 0.7), -2, random.between(-0.7, 0.7)});
    Color colors[2];
    for (const double overlap : {0.0, 1e-7}) {
      SceneBuilder k;
      k.scene.background = {0.1, 0.3, 0.8}, k.scene.max_depth = 7;
      scene::Material m = clear_material(1.5, true);
      m.color = Color{0.9, 0.8, 0.95}, m.refract = 0.9, m.ambient = m.diffuse = grey(0.3), m.specular = 0.4;
      const auto glass = k.material(m), floor = k.glow(0.6);
      std::vector<scene::Object> things{k.box({-2, -overlap, -2}, {0, 1, 2}).with(glass),
                                        k.box({-overlap, -overlap, -2}, {2, 1, 2}).with(glass),
                                        k.plane({0, 1, 0}, 0).with(floor)};
      shuffle(things, random);
      place(k, things, placement);
      k.sun(matrix(placement).vector({0.3, -1, 0.2}));
      colors[overlap > 0] = seen(k, ray);
    }
    const Color off = colors[0] - colors[1];
    REQUIRE(max_component(colors[0]) > 0.05);
    REQUIRE(std::max({std::abs(off.r), std::abs(off.g), std::abs(off.b)}) < 1e-6);
  }
}

TEST_CASE("contact: a glass that is filled with water is seen through as one where they overlap by 1e-7") {
  SplitMix64 random(1307);
  const Vec3 y{0, 1, 0};
  const auto cylinder = [&](SceneBuilder& k, double from, double to, double radius) {
    scene::Cylinder c;
    c.from = y * from, c.to = y * to, c.radius = radius;
    return k.shape(c);
  };
  int through_both = 0;
  for (int i = 0; i < 120; ++i) {
    const scene::Placement placement = anywhere(random, 1, 2);
    const double height = random.between(-1, 2.5), angle = random.between(-0.4, 0.4);
    const Ray ray =
        carried(placement, {random.between(-0.7, 0.7), height, 6}, {std::sin(angle) / 6, -height / 6 * 0.5, -1});
    Way ways[2];
    for (const double overlap : {0.0, 1e-7}) {
      SceneBuilder k;
      std::vector<scene::Object> things{
          k.subtract({cylinder(k, -0.2, 3, 1.1), cylinder(k, 0, 4, 1)}).with(k.clear(1.52)),
          cylinder(k, -overlap, 2, 1 + overlap).with(k.clear(1.333))};
      shuffle(things, random);
      place(k, things, placement);
      ways[overlap > 0] = follow(k, ray);
    }
    through_both += ways[0].most_touching == 2;
    CHECK(ways[0].bends == ways[1].bends);
    CHECK(length(ways[0].last.direction - ways[1].last.direction) < 2e-5);
  }
  CHECK(through_both > 60);
}
