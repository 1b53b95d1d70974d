// What the physical properties of a material mean in Whitted's model.

#include "renderer/scene/material.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::tests;

namespace {

constexpr scene::Metal gold{{0.1310, 0.4919, 1.4829}, {4.0624, 2.2399, 1.7805}};

scene::Material dark() {
  scene::Material m;
  m.ambient = m.diffuse = grey(0);
  return m;
}

/// A white room around it, and nothing that shines in it.
SceneBuilder in_white() {
  SceneBuilder k;
  k.scene.background = white;
  return k;
}

Color floor_in_white(const scene::Material& m, const Vec3& direction = {0, -1, 0}) {
  SceneBuilder k = in_white();
  k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
  return Asked(k).radiance(direction * -5, direction);
}

/// A slab 2 thick, seen from above along a unit direction; `inside` from its middle.
Color slab_in_white(const scene::Material& m, const Vec3& direction, bool inside = false) {
  SceneBuilder k = in_white();
  k.add(k.box({-50, -1, -50}, {50, 1, 50}).with(k.material(m)));
  return Asked(k).radiance(inside ? Vec3{} : direction * -20, direction);
}

scene::Material tea(double ior) {
  scene::Material m = dark();
  m.refract = 1.0;
  m.ior = ior;
  m.absorb = scene::Absorb{{0.5, 0.25, 1}, 4};
  return m;
}

} // namespace

TEST_CASE("whitted: a metal mirrors what it reflects at the normal, unless `reflect` is written") {
  scene::Material m = dark();
  m.metal = gold;
  const Color seen = floor_in_white(m);
  CHECK(seen.r == Approx(0.9705).margin(1e-4)); // n and k have four digits
  CHECK(seen.g == Approx(0.7284).margin(1e-4));
  CHECK(seen.b == Approx(0.3646).margin(1e-4));
  m.color = Color{1, 0.5, 1}; // `metallic` is 1
  CHECK(floor_in_white(m).g == Approx(0.7284 / 2).margin(2e-4));
  m.metallic = 0.0;
  CHECK(floor_in_white(m).g == Approx(0.7284).margin(1e-4));
  m.reflect = grey(0.25);
  CHECK(floor_in_white(m) == grey(0.25));
}

TEST_CASE("whitted: roughness makes highlights of the same width, unless `shininess` is written") {
  CHECK(scene::shininess_of(0.5) == Approx(30)); // 2/r⁴ − 2
  CHECK(scene::shininess_of(0.1) == Approx(19998));
  const auto lit = [](auto roughness, std::optional<double> shininess) {
    SceneBuilder k;
    scene::Material m = dark();
    m.specular = 1.0;
    m.roughness = roughness(k);
    if (shininess) m.shininess = *shininess;
    k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
    k.point_light({3, 3, 0}); // 45° from the normal, the half-way vector 22.5°
    return Asked(k).radiance({0, 5, 0}, {0, -1, 0}).g;
  };
  const double cosine = std::cos(3.14159265358979323846 / 8);
  const auto half = [](SceneBuilder&) -> scene::NumberPaint { return 0.5; };
  CHECK(lit(half, std::nullopt) == Approx(std::pow(cosine, 30)));
  CHECK(lit(half, 5) == Approx(std::pow(cosine, 5)));
  const auto pattern = [](SceneBuilder& k) -> scene::NumberPaint { return k.checker(grey(0.5), grey(0.5)); };
  CHECK(lit(pattern, std::nullopt) == Approx(std::pow(cosine, 30)));
}

TEST_CASE("whitted: a coat is a Fresnel mirror of its weight on top") {
  scene::Material m = dark();
  m.coat = 0.5;
  CHECK(floor_in_white(m).g == Approx(0.5 * 0.04)); // ((1.5 − 1)/(1.5 + 1))²
  m.coat_ior = 2;
  m.reflect = grey(0.25);
  CHECK(floor_in_white(m).g == Approx(0.25 + 0.5 / 9));
  m.coat_ior = 1.5;
  m.reflect = black;
  const double slanting = std::sqrt(0.75);
  CHECK(floor_in_white(m, {slanting, -0.5, 0}).g == Approx(0.5 * 0.0891867).margin(1e-7));
}

TEST_CASE("whitted: a medium leaves colour^(t/distance) of what is seen through it") {
  // 2 of 4: √½, ½ and 1.
  for (const double ior : {1.0, 1.5}) {
    const Color straight = slab_in_white(tea(ior), {0, -1, 0});
    CHECK(straight.r == Approx(std::sqrt(0.5)));
    CHECK(straight.g == Approx(0.5));
    CHECK(straight.b == Approx(1));
  }
  // At 60° the way is twice as long where nothing is bent; where it is, sin β = sin 60°/1.5.
  const Vec3 slanting{std::sqrt(0.75), -0.5, 0};
  CHECK(slab_in_white(tea(1), slanting).r == Approx(0.5));
  const double way = 2 / std::sqrt(1 - 0.75 / 2.25);
  CHECK(slab_in_white(tea(1.5), slanting).r == Approx(std::pow(0.5, way / 4)));
  // From the middle it is half as long, and nothing is left of what goes on for ever.
  CHECK(slab_in_white(tea(1), {0, -1, 0}, true).g == Approx(std::sqrt(0.5)));
  SceneBuilder k = in_white();
  k.add(k.plane({0, 1, 0}, 0).with(k.material(tea(1.5))));
  CHECK(Asked(k).radiance({0, 5, 0}, {0, -1, 0}) == Color{0, 0, 1});
}

TEST_CASE("whitted: the innermost medium alone absorbs") {
  SceneBuilder k = in_white();
  scene::Material clear = dark();
  clear.refract = 1.0;
  k.add(k.box({-50, -1, -50}, {50, 1, 50}).with(k.material(tea(1))));
  k.add(k.box({-25, -0.5, -25}, {25, 0.5, 25}).with(k.material(clear)));
  CHECK(Asked(k).radiance({0, 20, 0}, {0, -1, 0}).g == Approx(std::sqrt(0.5))); // 1 of 4
}

TEST_CASE("whitted: a thin sheet bends nothing and has no inside") {
  scene::Material m = tea(1.5);
  m.thin = true;
  m.color = grey(0.8);
  const Vec3 slanting{std::sqrt(0.75), -0.5, 0};
  CHECK(slab_in_white(m, slanting).r == Approx(0.64)); // twice 0.8; as a solid of glass it would be total reflection
  CHECK(slab_in_white(m, slanting, true).r == Approx(0.8));
  // With Fresnel's equations what is mirrored does not pass.
  m.fresnel = true;
  m.reflect = white;
  const double passed = 0.8 * (1 - 0.04);
  SceneBuilder k;
  k.add(k.plane({0, 1, 0}, 0).with(k.material(m)));
  scene::Material bright = dark();
  bright.emission = white;
  k.add(k.sphere(1).at({0, -5, 0}).with(k.material(bright)));
  CHECK(Asked(k).radiance({0, 5, 0}, {0, -1, 0}).g == Approx(passed));
}
