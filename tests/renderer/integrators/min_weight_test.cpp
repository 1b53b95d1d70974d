// Weak rays that are not followed.

#include "renderer/math/random.hpp"
#include "renderer/render/ray_query.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace rt;
using namespace rt::tests;

namespace {

scene::Material glass_of(double ior) {
  scene::Material m;
  m.color = Color{0.94, 0.97, 0.96}, m.diffuse = grey(0.02), m.ambient = grey(0);
  m.reflect = white, m.refract = 0.96, m.ior = ior, m.fresnel = true;
  return m;
}

// A tumbler with water in it, on a chequered table, under a sky: nothing is brighter than white.
SceneBuilder tumbler(int depth, double min_weight, const Color& sky = white) {
  SceneBuilder k;
  k.scene.background = sky, k.scene.max_depth = depth, k.scene.min_weight = min_weight;
  const auto cylinder = [&](double from, double to, double radius) {
    scene::Cylinder c;
    c.from = Vec3{0, from, 0}, c.to = Vec3{0, to, 0}, c.radius = radius;
    return k.shape(c);
  };
  k.add(k.subtract({cylinder(0, 3, 1.1), cylinder(0.3, 4, 1)}).with(k.material(glass_of(1.52))));
  k.add(cylinder(0.3, 2, 1).with(k.material(glass_of(1.333))));
  scene::Material table;
  table.color = k.checker(white, grey(0.1)), table.emission = grey(1), table.ambient = table.diffuse = grey(0);
  k.add(k.plane({0, 1, 0}, 0).with(k.material(table)));
  return k;
}

std::vector<Ray> rays_into_it() {
  std::vector<Ray> rays;
  SplitMix64 random(512);
  for (int i = 0; i < 300; ++i) {
    const Vec3 from{3, 3.5, 6}, to{random.between(-1, 1), random.between(0.2, 2.9), random.between(-0.5, 0.5)};
    rays.push_back({from, normalize(to - from)});
  }
  return rays;
}

struct Traced {
  std::vector<Color> colors;
  RayCounts counts;
};

Traced traced(const SceneBuilder& k, const std::vector<Ray>& rays) {
  const CompiledScene compiled(k.scene, 1);
  NoRecorder none;
  Whitted<> whitted(compiled, none);
  Traced result;
  for (const Ray& ray : rays) result.colors.push_back(whitted.radiance(ray, {}));
  result.counts = whitted.counts();
  return result;
}

} // namespace

TEST_CASE("min_weight: where nothing is brighter than white no sRGB value moves by more than it") {
  const std::vector<Ray> rays = rays_into_it();
  for (const Color& sky : {white, grey(0.01), Color{0.9, 0.05, 0}}) {
    const Traced whole = traced(tumbler(10, 0, sky), rays);
    for (const double least : {0x1p-9, 0x1p-6, 0.1}) {
      const Traced pruned = traced(tumbler(10, least, sky), rays);
      CHECK(pruned.counts.total() < whole.counts.total() / 2);
      double most = 0;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        for (const auto channel : {&Color::r, &Color::g, &Color::b}) {
          const double moved = linear_to_srgb(whole.colors[i].*channel) - linear_to_srgb(pruned.colors[i].*channel);
          most = std::max(most, std::abs(moved));
        }
      }
      CHECK(most <= least);
      CHECK(most > 0);
    }
  }
}

TEST_CASE("min_weight: the mean of a pixel's samples moves by no more than it either") {
  // Of samples that are black, grey of any level, or white, any number each, all as much too dark as is allowed.
  SplitMix64 random(255);
  for (int i = 0; i < 10'000; ++i) {
    const double level = random.between(0, 0.02), blacks = random.between(0, 1), whites = random.between(0, 1 - blacks);
    const double pruned = whites + (1 - blacks - whites) * level;
    const double lost = blacks * light_allowance(black) + whites * light_allowance(white) +
                        (1 - blacks - whites) * light_allowance(grey(level));
    REQUIRE(linear_to_srgb(pruned + lost * 0x1p-9) - linear_to_srgb(pruned) <= 0x1p-9);
  }
}

TEST_CASE("min_weight: depth 20 costs hardly more than depth 8") {
  const std::vector<Ray> rays = rays_into_it();
  const auto cost = [&](int depth) { return static_cast<double>(traced(tumbler(depth, 0x1p-9), rays).counts.total()); };
  CHECK(cost(20) <= 1.3 * cost(8));
}

TEST_CASE("min_weight: parallel mirrors are followed down to it, and what is left out is what they have shown") {
  // ρ = ½, e = 0.1: all light is 0.2, and so is what comes in along any ray. 0.07 + 2.2·0.2 = 0.51 of `min_weight` may
  // be missing, a 24th of that at once, and 0.3 of a ray's weight counts. So a ray that weighs ⅛ of `min_weight` is
  // followed, one of 1/16 is not: that is less than 0.51 / (24 · 0.3) = 0.071.
  SceneBuilder k;
  scene::Material m;
  m.ambient = m.diffuse = grey(0), m.emission = grey(0.1), m.reflect = grey(0.5);
  const auto half = k.material(m);
  k.add(k.plane({0, 0, 1}, -1).with(half));
  k.add(k.plane({0, 0, -1}, -1).with(half));
  k.scene.max_depth = 100;
  for (const double least : {0x1p-9, 0x1p-20}) {
    k.scene.min_weight = least;
    const Traced pruned = traced(k, {{{0, 0, 0}, {0, 0, 1}}});
    CHECK(pruned.colors[0].r == Approx(0.2).epsilon(1e-14));
    CHECK(pruned.counts.reflected == static_cast<std::uint64_t>(3 - std::log2(least)));
  }
}

TEST_CASE("min_weight: a ray sees the same alone, in company and while it is recorded") {
  const std::vector<Ray> rays = rays_into_it();
  const SceneBuilder k = tumbler(12, 0x1p-9);
  const Traced alone = traced(k, rays);
  const CompiledScene compiled(k.scene, 1);
  NoRecorder none;
  Whitted<> whitted(compiled, none);
  for (std::size_t i = 0; i + camera_batch_size <= rays.size(); i += camera_batch_size) {
    std::array<Color, camera_batch_size> together;
    whitted.radiance(std::span(rays).subspan(i, camera_batch_size), {}, together);
    for (std::size_t n = 0; n < camera_batch_size; ++n) REQUIRE(together[n] == alone.colors[i + n]);
  }
  struct Listener : NoRecorder {
    int weak = 0;
    void too_weak(double, const Color&) { ++weak; }
  } listener;
  Whitted<OwnRules, Listener> recorded(compiled, listener);
  for (std::size_t i = 0; i < 20; ++i) REQUIRE(recorded.radiance(rays[i], {}) == alone.colors[i]);
  CHECK(listener.weak > 0);
}
