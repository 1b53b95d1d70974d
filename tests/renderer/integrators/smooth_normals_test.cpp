// Triangles that look curved, where their interpolated normals face away from the viewer.

#include "renderer/math/random.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace rt;
using namespace rt::tests;

namespace {

const double pi = 3.14159265358979323846;

void add_triangle(SceneBuilder& k, const std::array<Vec3, 3>& points, const std::array<Vec3, 3>& normals,
                  scene::MaterialId material) {
  scene::Triangle t;
  t.points = points, t.normals.assign(normals.begin(), normals.end());
  k.add(k.shape(t).with(material));
}

// With corners on the unit sphere, in an order that changes from one triangle to the next, and the sphere's normals
// there.
void add_ball(SceneBuilder& k, int segments, scene::MaterialId material) {
  const auto corner = [&](int i, int j) {
    const double polar = pi * i / segments, around = pi * j / segments;
    return Vec3{std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)};
  };
  for (int i = 0; i < segments; ++i) {
    for (int j = 0; j < 2 * segments; ++j) {
      const Vec3 a = corner(i, j), b = corner(i, j + 1), c = corner(i + 1, j), d = corner(i + 1, j + 1);
      if (i > 0) add_triangle(k, {a, b, c}, {a, b, c}, material);
      if (i + 1 < segments) add_triangle(k, {d, b, c}, {d, b, c}, material);
    }
  }
}

void add_shadowless_sun(SceneBuilder& k, const Vec3& direction) {
  scene::SunLight sun;
  sun.direction = direction, sun.shadows = false;
  k.add(sun);
}

} // namespace

TEST_CASE("smooth normals: a normal that faces away from the viewer is lit from its own side") {
  SceneBuilder k;
  scene::Material m;
  m.diffuse = grey(1);
  const auto angle = [](double degrees) { return Vec3{std::sin(degrees * pi / 180), 0, std::cos(degrees * pi / 180)}; };
  const Vec3 n = angle(80);
  add_triangle(k, {Vec3{-1, -1, 0}, Vec3{1, -1, 0}, Vec3{0, 1, 0}}, {n, n, n}, k.material(m));
  k.sun(-angle(60));
  // From −30° the face is seen from its front, its normal from behind: they are 110° apart. The light's angle with it
  // is 20° from wherever it is seen.
  for (const double view : {-30.0, 0.0, 40.0})
    CHECK(Asked(k).radiance(angle(view) * 5, -angle(view)).r == Approx(std::cos(20 * pi / 180)).epsilon(1e-12));
  // From behind the face everything is turned over: no light comes there.
  CHECK(Asked(k).radiance(angle(170) * 5, -angle(170)).r == 0);
}

TEST_CASE("smooth normals: a ball of few triangles is shaded as a sphere to its rim, from all sides") {
  SplitMix64 random(80);
  for (const int segments : {3, 5, 9}) {
    SceneBuilder k;
    scene::Material m;
    m.diffuse = grey(1);
    add_ball(k, segments, k.material(m));
    const Vec3 to_light = normalize(Vec3{0.3, 0.8, 0.5});
    add_shadowless_sun(k, -to_light);
    Asked asked(k);
    int facing_away = 0;
    for (int i = 0; i < 4000; ++i) {
      const auto on_sphere = [&] {
        const double y = random.between(-1, 1), around = random.between(0, 2 * pi), r = std::sqrt(1 - y * y);
        return Vec3{r * std::cos(around), y, r * std::sin(around)};
      };
      const Vec3 from = on_sphere() * 6, direction = normalize(on_sphere() - from);
      const RayHit hit = asked.nearest(from, direction);
      if (!hit) continue;
      // Where the corners' normals are their positions, the interpolated one points where the point itself lies.
      const Vec3 n = normalize(from + direction * hit.t);
      facing_away += dot(n, direction) > 0;
      REQUIRE(asked.radiance(from, direction).r == Approx(std::max(0.0, dot(n, to_light))).margin(1e-9));
    }
    CHECK(facing_away > 50);
  }
}

TEST_CASE("smooth normals: a mirror whose normal faces away shows what is before it, nothing behind it") {
  SceneBuilder k;
  scene::Material m;
  m.ambient = m.diffuse = grey(0), m.reflect = white;
  const Vec3 n = normalize(Vec3{1, 0, 0.2});
  add_triangle(k, {Vec3{-9, -9, 0}, Vec3{9, -9, 0}, Vec3{0, 9, 0}}, {n, n, n}, k.material(m));
  k.add(k.plane({0, 0, 1}, -1).with(k.glow(1))); // behind it
  k.scene.background = grey(0.25);
  for (const double x : {-0.5, -1.0, -3.0}) CHECK(Asked(k).radiance({x, 0, 1}, {-x, 0, -1}) == grey(0.25));
}
