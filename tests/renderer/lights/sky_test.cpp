#include "renderer/render/ray_query.hpp"
#include "tests/support/estimates.hpp"

using namespace rt;
using namespace rt::tests;

namespace {

scene::SkyLight gradient() {
  scene::SkyLight sky;
  sky.zenith = {0.2, 1, 0.8}, sky.horizon = {1, 0.4, 0.6};
  return sky;
}

} // namespace

TEST_CASE("sky: rays that meet nothing see it, in both modes") {
  SceneBuilder k;
  k.add(gradient());
  k.scene.background = white; // takes no part any more
  const RayQuery query(k.scene, 1);
  for (const IntegratorKind kind : {IntegratorKind::whitted, IntegratorKind::path}) {
    const auto seen = [&](const Vec3& direction) { return query.radiance({{}, direction}, kind); };
    CHECK(seen({0, 1, 0}).r == Approx(0.2));
    CHECK(seen({0, 1, 0}).g == Approx(1));
    CHECK(seen({0, 0, 1}) == Color{1, 0.4, 0.6});
    CHECK(seen({0.8, 0.6, 0}).r == Approx(1 - 0.8 * 0.6));
    CHECK(seen({0.8, -0.6, 0}).r == Approx(0.3));
    CHECK(seen({0, -1, 0}).g == Approx(0.12));
  }
}

TEST_CASE("sky: it turns with its chain") {
  SceneBuilder k;
  k.add(gradient()).chain.push_back(scene::RotateStep{{0, 0, -90}, {}}); // up becomes +x
  const RayQuery query(k.scene, 1);
  CHECK(query.radiance({{}, {1, 0, 0}}).r == Approx(0.2));
  CHECK(query.radiance({{}, {0, -1, 0}}).r == Approx(1));
}

// Facing up: π(h/3 + 2z/3); facing down only the ground is seen.
TEST_CASE("sky: the light that falls from it on a surface") {
  SceneBuilder k, l;
  k.scene.max_depth = l.scene.max_depth = 0;
  k.add(gradient());
  l.add(gradient());
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 12), 0.8 * std::numbers::pi, 2e-3);
  check_estimate(irradiance(l, {}, {0, -1, 0}, 1 << 10), 0.12 * std::numbers::pi, 1e-6);
}
