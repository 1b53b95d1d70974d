#include "renderer/render/ray_query.hpp"
#include "tests/support/estimates.hpp"
#include "tests/support/shapes.hpp"

#include <set>

using namespace rt;
using namespace rt::tests;

namespace {

scene::Material lambert(double albedo, double emission = 0) {
  scene::Material m;
  m.diffuse = grey(albedo), m.emission = grey(emission);
  return m;
}

scene::Object endless_cylinder(SceneBuilder& k, double radius, scene::MaterialId material) {
  scene::Cylinder c;
  c.axis = Vec3{0, 0, 1}, c.radius = radius, c.infinite = true;
  return k.shape(c).with(material);
}

bool is_near(const Color& a, const Color& b, double distance) {
  return std::abs(a.r - b.r) <= distance && std::abs(a.g - b.g) <= distance && std::abs(a.b - b.b) <= distance;
}

} // namespace

// Without anything that is random: lamps without size, a black background, no light between surfaces.
TEST_CASE("path: on Lambert surfaces under lamps without size it is Whitted's model to 1e-12") {
  SceneBuilder k;
  k.scene.max_depth = 0;
  k.add(k.plane({0, 1, 0}, -1).with(k.material(Color{0.9, 0.8, 0.7})));
  k.add(k.sphere().with(k.material(Color{0.3, 0.6, 0.9})));
  k.add(k.sphere(0.5).at({1.5, 0, 0.5}).with(k.clear(1.5, 0.7)));
  k.add(k.box({-2, -1, -1}, {-1.2, 1, 1}));
  scene::Triangle smooth;
  smooth.points = {Vec3{-1, 1, 1}, Vec3{1, 1, 1}, Vec3{0, 2, 0}};
  smooth.normals = {Vec3{-1, 1, 1}, Vec3{1, 1, 1}, Vec3{0, 1, -1}};
  k.add(k.shape(smooth));
  k.point_light({2, 4, 3}, {1, 0.9, 0.8});
  k.sun({-1, -2, -1}, grey(0.4));
  scene::SpotLight spot;
  spot.at = {-3, 3, 3}, spot.fade.law = scene::Fade::Law::inverse_square, spot.intensity = 5, spot.falloff = 60;
  k.add(spot);
  const RayQuery query(k.scene, 1);
  Random random(7);
  int bright = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = random.vector(-1, 1) + Vec3{0, 2, 6};
    const Ray ray{from, normalize(random.vector(-1.5, 1.5) - from)};
    const auto hit = query.nearest(ray);
    if (hit && hit->material.refract > 0) continue; // what is seen through it is not of the first surface
    const Color ours = query.radiance(ray, IntegratorKind::path), theirs = query.radiance(ray);
    CHECK(is_near(ours, theirs, 1e-12));
    bright += ours.g > 0.05;
  }
  CHECK(bright > 500);
}

// Mirrors and panes of which every ray goes one way only.
TEST_CASE("path: in mirrors and through glass without reflection it sees what Whitted's model sees") {
  SceneBuilder k;
  k.scene.background = {0.2, 0.4, 0.8};
  scene::Material mirror;
  mirror.reflect = Color{0.9, 0.7, 0.5}, mirror.diffuse = grey(0);
  k.add(k.sphere().with(k.material(mirror)));
  k.add(k.sphere().at({2.2, 0, 0}).with(k.clear(1.5, 0.9)));
  k.add(k.shape(scene::Disc{}).at({0, -1.2, 0}).transformed(k.scaled({9, 1, 9})).with(k.glow(0.3)));
  const RayQuery query(k.scene, 1);
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = random.vector(-1, 1) + Vec3{1, 2, 6};
    const Ray ray{from, normalize(random.vector(-1.5, 2.5) - from)};
    const Color ours = query.radiance(ray, IntegratorKind::path), theirs = query.radiance(ray);
    INFO(ours.r << " " << ours.g << " " << ours.b << ", " << theirs.r << " " << theirs.g << " " << theirs.b);
    CHECK(is_near(ours, theirs, 1e-12));
  }
}

// A convex body of albedo ρ in an environment of radiance 1 shows ρ; glass shows 1, however light runs in it.
TEST_CASE("path: white furnaces") {
  SceneBuilder k;
  k.scene.background = white;
  scene::Material glass;
  glass.refract = 1.0, glass.ior = 1.5, glass.fresnel = true, glass.reflect = white, glass.diffuse = grey(0);
  k.add(k.sphere().at({-3, 0, 0}).with(k.material(lambert(0.6))));
  k.add(k.box({-1, -1, -1}, {1, 1, 1}).transformed(k.rotated({20, 30, 40})).with(k.material(lambert(0.3))));
  k.add(k.sphere().at({3, 0, 0}).with(k.material(glass)));
  k.add(k.box({5, -1, -1}, {7, 1, 1}).with(k.material(glass)));
  const CompiledScene scene(k.scene, 1);
  // Bodies see one another: the first two alone.
  SceneBuilder one, two;
  one.scene.background = two.scene.background = white;
  one.add(one.sphere().with(one.material(lambert(0.6))));
  two.add(two.box({-1, -1, -1}, {1, 1, 1}).transformed(two.rotated({20, 30, 40})).with(two.material(lambert(0.3))));
  check_estimate(estimate(CompiledScene(one.scene, 1), {{0.3, 0.2, 5}, {0, 0, -1}}, 64), 0.6, 1e-12);
  check_estimate(estimate(CompiledScene(two.scene, 1), {{0.3, 0.2, 5}, {0, 0, -1}}, 64), 0.3, 1e-12);
  SceneBuilder three;
  three.scene.background = white;
  three.scene.max_depth = 1000;
  three.add(three.sphere().with(three.material(glass)));
  three.add(three.box({2, -1, -1}, {4, 1, 1}).with(three.material(glass)));
  const CompiledScene glassy(three.scene, 1);
  for (const double x : {0.0, 0.5, 0.9, 3.0})
    check_estimate(estimate(glassy, {{x, 0.2, 5}, normalize(Vec3{0.1, 0, -1})}, 1024), 1, 0.02);
}

// A closed room, all of one albedo and all emitting 1, is filled with 1/(1 − ρ): after n bounces (1 − ρ^(n+1))/(1 − ρ).
TEST_CASE("path: closed rooms") {
  for (const bool is_box : {false, true}) {
    for (const auto& [depth, expected] : {std::pair{0, 1.5}, {1, 1.75}, {3, 1.9375}, {1000, 2.0}}) {
      SceneBuilder k;
      k.scene.max_depth = depth;
      const scene::MaterialId wall = k.material(lambert(0.5, 1));
      k.add(is_box ? k.box({-1, -1, -1}, {1, 2, 1}).with(wall) : k.sphere(2).with(wall));
      check_estimate(estimate(CompiledScene(k.scene, 1), {{0.2, 0.1, 0}, normalize(Vec3{0.3, 0.2, 1})}, 1 << 11),
                     expected, 0.02);
    }
  }
}

// Balls of radius 1 and 2, the inner one emits 1 and is black, the outer has ρ = ½: outer 0.2. With ρ = 0.4 inside:
// outer 0.2173913, inner 1.0869565.
TEST_CASE("path: concentric balls") {
  SceneBuilder k, l;
  k.add(k.sphere().with(k.glow(1)));
  k.add(k.sphere(2).with(k.material(lambert(0.5))));
  check_estimate(estimate(CompiledScene(k.scene, 1), {{1.5, 0, 0}, {1, 0, 0}}, 1 << 12), 0.2, 1e-3);
  l.add(l.sphere().with(l.material(lambert(0.4, 1))));
  l.add(l.sphere(2).with(l.material(lambert(0.5))));
  const CompiledScene both(l.scene, 1);
  check_estimate(estimate(both, {{1.5, 0, 0}, {1, 0, 0}}, 1 << 12), 0.2173913, 1e-3);
  check_estimate(estimate(both, {{1.5, 0, 0}, {-1, 0, 0}}, 1 << 12), 1.0869565, 1e-3);
}

// Endless lamps are found by chance alone. Cylinders of radius 1 and 2: ⅓. Planes of ρ 0.3, which emits 1, and 0.6:
// 1/(1 − 0.18) = 1.2195122, and 0.6 of it.
TEST_CASE("path: endless cylinders and planes") {
  SceneBuilder k, l;
  k.add(endless_cylinder(k, 1, k.glow(1)));
  k.add(endless_cylinder(k, 2, k.material(lambert(0.5))));
  check_estimate(estimate(CompiledScene(k.scene, 1), {{1.5, 0, 0}, {1, 0, 0}}, 1 << 12), 1.0 / 3, 3e-3);
  l.add(l.plane({0, 1, 0}, 0).with(l.material(lambert(0.3, 1))));
  l.add(l.plane({0, 1, 0}, 1).with(l.material(lambert(0.6))));
  const CompiledScene planes(l.scene, 1);
  check_estimate(estimate(planes, {{0, 0.5, 0}, {0, -1, 0}}, 1 << 12), 1.2195122, 5e-3);
  check_estimate(estimate(planes, {{0, 0.5, 0}, {0, 1, 0}}, 1 << 12), 0.7317073, 5e-3);
}

// A ball of radius 1, ρ = ½, a lamp of intensity 1 half-way from the centre: what leaves a point is ρ/π·(E + the ball's
// even rest). E is π·cos/d² and its mean over the ball π·4π/(4π): 1/2·(cos/d² + 1).
TEST_CASE("path: a lamp without size in a ball") {
  SceneBuilder k;
  scene::PointLight lamp;
  lamp.at = {0, 0.5, 0}, lamp.fade.law = scene::Fade::Law::inverse_square;
  k.add(lamp);
  k.add(k.sphere().with(k.material(lambert(0.5))));
  const CompiledScene scene(k.scene, 1);
  const auto seen_at = [&](const Vec3& point) { return estimate(scene, {{}, point}, 1 << 12); };
  check_estimate(seen_at({0, 1, 0}), 2.5, 0.01);
  check_estimate(seen_at({1, 0, 0}), 0.8577709, 0.01);
  check_estimate(seen_at({0, -1, 0}), 0.7222222, 0.01);
}

// 40 lamps stand for each other from the 17th on; they hang together where one of 40 would.
TEST_CASE("path: of many lamps without size one is asked") {
  SceneBuilder k;
  k.scene.max_depth = 0;
  k.add(k.plane({0, 1, 0}, 0));
  for (int i = 0; i < 40; ++i) k.point_light({i * 0.1 - 2, 2 + 0.05 * i, 1}, grey(1.0 / (i + 1)));
  const RayQuery query(k.scene, 1);
  const Ray ray{{0, 1, 0}, {0, -1, 0}};
  check_estimate(estimate(query.scene(), ray, 1 << 12), query.radiance(ray).g, 0.01);
}

// A mirror's ground gets what it leaves: 0.6 + 0.4·0.9 is no more than there is. What is above 1 is divided.
TEST_CASE("path: materials that would make light make none") {
  SceneBuilder k;
  k.scene.background = white;
  k.scene.max_depth = 1000;
  scene::Material shiny = lambert(0.9);
  shiny.reflect = grey(0.6);
  scene::Material bright = lambert(1);
  bright.color = grey(3);
  k.add(k.sphere().with(k.material(shiny)));
  scene::Material both;
  both.diffuse = grey(0), both.reflect = grey(0.8), both.refract = 0.6;
  k.add(k.sphere().at({5, 0, 0}).with(k.material(bright)));
  k.add(k.shape(scene::Disc{}).at({10, 0, 0}).with(k.material(both)));
  const CompiledScene scene(k.scene, 1);
  check_estimate(estimate(scene, {{0.3, 0, 3}, {0, 0, -1}}, 256), 0.96, 1e-9);
  check_estimate(estimate(scene, {{5.3, 0, 3}, {0, 0, -1}}, 256), 1, 1e-9);
  check_estimate(estimate(scene, {{10.3, 3, 0}, {0, -1, 0}}, 256), 1, 1e-9);
}
