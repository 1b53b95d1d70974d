#include "renderer/render/ray_query.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

// What POV-Ray itself shows of these rays: tests/oracle/facts_test.cpp.
namespace {

HitReport first_hit(const scene::Scene& scene, HitRules rules, const Ray& ray) {
  const auto hit = RayQuery(scene, 1, rules).nearest(ray);
  REQUIRE(hit);
  return *hit;
}

const Vec3 minus_x{-1, 0, 0}, minus_y{0, -1, 0};

} // namespace

TEST_CASE("POV-Ray's box: of two faces met within 1e-6 the steeper one counts, where the first one is met") {
  SceneBuilder alone, in_group, in_solid;
  alone.add(alone.box({0, 0, 0}, {1, 1, 1}));
  in_group.add(in_group.group({in_group.box({-1, -1, -1}, {1, 1, 1})})
                   .at({0.5, 0.5, 0.5})
                   .transformed(in_group.scaled({0.5, 0.5, 0.5})));
  in_solid.add(in_solid.intersect({in_solid.box({0, 0, 0}, {1, 1, 1}), in_solid.sphere(50)}));
  for (const scene::Scene& scene : {alone.scene, in_group.scene, in_solid.scene}) {
    const auto normal = [&](HitRules rules, const Ray& ray) { return first_hit(scene, rules, ray).normal; };
    const Vec3 steep_y{0.6, 0.8, 0}, steep_x{0.8, 0.6, 0};
    CHECK(normal(HitRules::own, {{-3, -4 + 7e-7, 0.5}, steep_y}) == minus_x);
    CHECK(normal(HitRules::povray, {{-3, -4 + 7e-7, 0.5}, steep_y}) == minus_y);
    CHECK(normal(HitRules::povray, {{-3, -4 + 1e-6, 0.5}, steep_y}) == minus_x);

    const Ray below{{-4, -3 - 5e-7, 0.5}, steep_x};
    CHECK(normal(HitRules::own, below) == minus_y);
    CHECK(normal(HitRules::povray, below) == minus_x);
    CHECK(first_hit(scene, HitRules::own, below).t == Approx(5 + 5e-7 / 0.6).epsilon(1e-14));
    CHECK(first_hit(scene, HitRules::povray, below).t == Approx(5).epsilon(1e-14));
    CHECK(normal(HitRules::povray, {{-4, -3 - 7e-7, 0.5}, steep_x}) == minus_y);
  }
}

TEST_CASE("POV-Ray's box: a corner that its bounding box has no digits for is missed") {
  const Ray ray{{13, 11, 17}, {-0.47964633530265394, -0.33752297627874556, -0.8099491548947202}};
  const auto is_met = [&](const scene::Scene& scene, HitRules rules) {
    return RayQuery(scene, 1, rules).nearest(ray).has_value();
  };
  SceneBuilder straight, turned;
  straight.add(straight.box({0.53, -1, -2.47}, {1.47, 3.0353615262336637, -1.53}));
  turned.add(turned.box({1.53, -1, 0.53}, {2.47, 3.0353615262336637, 1.47}).transformed(turned.rotated({0, 90, 0})));
  for (const scene::Scene& scene : {straight.scene, turned.scene}) CHECK(is_met(scene, HitRules::own));
  CHECK_FALSE(is_met(straight.scene, HitRules::povray));
  CHECK_FALSE(is_met(turned.scene, HitRules::povray));
}
