// Bumps bend normals: n − ∇h along the surface, heights being in lengths of the object that writes the material.

#include "renderer/render/ray_query.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using rt::tests::SceneBuilder;

namespace {

// Heights that rise with x: by half of it.
scene::MaterialId ramp(SceneBuilder& build, const scene::Placement& placement = {}) {
  scene::Gradient gradient;
  gradient.direction = {1, 0, 0};
  gradient.stops = {{0, black}, {1, grey(0.5)}};
  scene::Material m;
  m.bump = build.pattern({gradient, placement});
  return build.material(m);
}

void check_normal(const scene::Scene& scene, const Vec3& origin, const Vec3& direction, const Vec3& expected) {
  const auto hit = RayQuery(scene, 1).nearest({origin, direction});
  REQUIRE(hit);
  const Vec3 unit = normalize(expected);
  INFO(hit->shading_normal.x << ", " << hit->shading_normal.y << ", " << hit->shading_normal.z);
  CHECK(length(hit->shading_normal - unit) < 1e-9);
  CHECK(length(hit->normal - Vec3{0, 1, 0}) < 1e-12);
}

constexpr Vec3 above{0.3, 2, 0.2}, down{0, -1, 0};

} // namespace

TEST_CASE("bump: the slope of the heights leans the normal back") {
  SceneBuilder build;
  build.add(build.plane({0, 1, 0}, 0).with(ramp(build)));
  check_normal(build.scene, above, down, {-0.5, 1, 0});
}

TEST_CASE("bump: a pattern that is scaled or turned in its place takes its slope along") {
  SceneBuilder build;
  build.add(build.plane({0, 1, 0}, 0).with(ramp(build, {.scale = {2, 2, 2}})));
  check_normal(build.scene, above, down, {-0.25, 1, 0});
  SceneBuilder turned;
  turned.add(turned.plane({0, 1, 0}, 0).with(ramp(turned, {.rotate = {0, -90, 0}}))); // x becomes z
  check_normal(turned.scene, {0.3, 2, 0.2}, down, {0, 1, -0.5});
}

TEST_CASE("bump: what is enlarged is enlarged with its bumps, and they are turned with it") {
  SceneBuilder build;
  build.add(build.box({-1, -1, -1}, {1, 0.1, 1}).transformed(build.scaled({3, 3, 3})).with(ramp(build)));
  check_normal(build.scene, above, down, {-0.5, 1, 0});
  // Twice as long as high: the heights stay, their slope is halved.
  SceneBuilder longer;
  longer.add(longer.box({-1, -1, -1}, {1, 0.1, 1}).transformed(longer.scaled({2, 1, 1})).with(ramp(longer)));
  check_normal(longer.scene, above, down, {-0.25, 1, 0});
  SceneBuilder turned;
  turned.add(turned.box({-1, -1, -1}, {1, 0.1, 1}).transformed(turned.rotated({0, -90, 0})).with(ramp(turned)));
  check_normal(turned.scene, above, down, {0, 1, -0.5});
}

TEST_CASE("bump: a group's material bends the normals of all that stands in it, however often it is placed") {
  SceneBuilder build;
  const auto box = build.group({build.box({-1, -1, -1}, {1, 0.1, 1})});
  const scene::Object part = box;
  for (const double x : {0.0, 40.0}) {
    scene::Object copy = part;
    copy.material = ramp(build);
    copy.transform = build.scaled({4, 2, 2});
    copy.at = {x, 0, 0};
    build.add(copy);
  }
  check_normal(build.scene, above, down, {-0.25, 1, 0});
  check_normal(build.scene, {40.3, 2, 0.2}, down, {-0.25, 1, 0});
}

TEST_CASE("bump: on solids of solids the normal out of the whole is bent") {
  SceneBuilder build;
  // The floor of a hole: seen from above its normal points up, out of the box that it was cut into.
  build.add(
      build.subtract({build.box({-2, -2, -2}, {2, 1, 2}), build.box({-1, -0.5, -1}, {1, 3, 1}).with(ramp(build))}));
  check_normal(build.scene, above, down, {-0.5, 1, 0});
}

TEST_CASE("bump: level heights, and those that change along the normal alone, bend nothing") {
  for (const Vec3& direction : {Vec3{0, 1, 0}, Vec3{1, 0, 0}}) {
    SceneBuilder build;
    scene::Gradient gradient;
    gradient.direction = direction;
    gradient.repeat = direction.y == 1;
    gradient.stops = {{0, grey(0.5)}, {1, grey(direction.y == 1 ? 3 : 0.5)}};
    scene::Material m;
    m.bump = build.pattern({gradient, {.at = {0, 0.3, 0}}});
    build.add(build.plane({0, 1, 0}, 0).with(build.material(m)));
    check_normal(build.scene, above, down, {0, 1, 0});
  }
}

TEST_CASE("bump: however steep, the normal stays on its side, and seen at a grazing angle nothing is black") {
  SceneBuilder build;
  scene::Leopard heights;
  heights.stops = {{0, black}, {1, grey(3)}};
  scene::Material m;
  m.bump = build.pattern({heights, {.scale = {0.05, 0.05, 0.05}}});
  m.ambient = grey(0), m.diffuse = grey(0), m.reflect = Color{1, 1, 1};
  build.scene.background = white;
  build.add(build.plane({0, 1, 0}, 0).with(build.material(m)));
  const RayQuery query(build.scene, 1);
  for (int i = 0; i < 500; ++i) {
    const Ray ray{{0.01 * i, 0.02, 0.013 * i}, normalize(Vec3{1, -0.02, 0.3})};
    const auto hit = query.nearest(ray);
    REQUIRE(hit);
    CHECK(dot(hit->shading_normal, hit->normal) > 0);
    CHECK(query.radiance(ray) == white); // the mirrored ray leaves the surface, whatever the normal
  }
}
