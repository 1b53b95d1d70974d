#include "renderer/render/ray_query.hpp"
#include "tests/support/estimates.hpp"

using namespace rt;
using namespace rt::tests;
using std::numbers::pi;

namespace {

// A lamp is found by chance as seldom as it is small, and those paths' share, 2 sin² of its half angle at most, may be
// missing altogether.
void check_light(const Estimate& found, double expected) {
  INFO("found " << found.mean << " ± " << found.error << ", expected " << expected);
  CHECK(found.error <= 0.02);
  CHECK(std::abs(found.mean - expected) <= 4.5 * found.error + 1e-4 * expected);
}

} // namespace

// Whatever its size, a lamp that faces a surface gives it π·intensity·fade(D), D to its middle.
TEST_CASE("sized lamps: a lamp's size leaves the brightness alone") {
  for (const double radius : {0.001, 0.3, 1.5}) {
    SceneBuilder k, l;
    k.scene.max_depth = l.scene.max_depth = 0;
    scene::PointLight lamp;
    lamp.at = {0, 3, 0}, lamp.radius = radius, lamp.intensity = 12, lamp.fade.law = scene::Fade::Law::inverse_square;
    k.add(lamp);
    check_light(irradiance(k, {}, {0, 1, 0}, 1 << 11), 4.1887902);
    lamp.fade.law = scene::Fade::Law::none, lamp.intensity = 1;
    l.add(lamp);
    check_light(irradiance(l, {}, {0, 1, 0}, 1 << 11), pi);
  }
  for (const double size : {0.533, 40.0}) {
    SceneBuilder k;
    k.scene.max_depth = 0;
    scene::SunLight sun;
    sun.direction = {0, -1, 0}, sun.size = size;
    k.add(sun);
    check_light(irradiance(k, {}, {0, 1, 0}, 1 << 11), pi);
  }
}

// intensity/sin²(size/2): 46,222.56 for 0.533°. A ball of intensity 12 and radius 0.3: 12/0.09.
TEST_CASE("sized lamps: they are seen, with the radiance that makes them so bright") {
  SceneBuilder k;
  scene::SunLight sun;
  sun.direction = {0, 0, 1}, sun.size = 0.533;
  k.add(sun);
  scene::PointLight lamp;
  lamp.at = {2, 0, -5}, lamp.radius = 0.3, lamp.intensity = 12, lamp.fade.law = scene::Fade::Law::inverse_square;
  k.add(lamp);
  const RayQuery query(k.scene, 1);
  const auto seen = [&](const Vec3& direction) {
    return query.radiance({{}, normalize(direction)}, IntegratorKind::path).g;
  };
  CHECK(seen({0, 0, -1}) == Approx(46222.56).epsilon(1e-6));
  CHECK(seen({0.004, 0, -1}) == Approx(46222.56).epsilon(1e-6)); // 0.23°
  CHECK(seen({0.005, 0, -1}) == 0);                              // 0.29°
  CHECK(seen({2, 0, -5}) == Approx(133.3333));
  CHECK(seen({2.4, 0, -5}) == 0);
}

// A ball of radius 1 at the height 3 behind a board with a round hole: seen from below the middle of the hole, it is a
// disc whose rim the board hides. The cone that is seen has the hole's sine: E = π·12/1·sin²… of radiance 12.
TEST_CASE("sized lamps: what stands before a lamp hides a part of it") {
  SceneBuilder k;
  k.scene.max_depth = 0;
  scene::PointLight lamp;
  lamp.at = {0, 3, 0}, lamp.radius = 1, lamp.intensity = 12, lamp.fade.law = scene::Fade::Law::inverse_square;
  k.add(lamp);
  scene::Disc board;
  board.radius = 50, board.hole = 0.2;
  k.add(k.shape(board).at({0, 1, 0}));
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 13), 12 * pi * 0.04 / 1.04, 1e-2);
}

TEST_CASE("sized lamps: one hides another, and a lamp that nothing blocks has no size") {
  SceneBuilder k, l;
  k.scene.max_depth = l.scene.max_depth = 0;
  scene::PointLight dim, bright;
  dim.at = {0, 2, 0}, dim.radius = 0.5, dim.intensity = 1;
  bright.at = {0, 8, 0}, bright.radius = 0.5, bright.intensity = 100; // behind it
  k.add(dim), k.add(bright);
  check_estimate(irradiance(k, {}, {0, 1, 0}, 1 << 12), pi, 0.1);
  dim.shadows = bright.shadows = false;
  l.add(dim), l.add(bright);
  check_estimate(irradiance(l, {}, {0, 1, 0}, 1 << 8), 101 * pi, 1e-6);
}
