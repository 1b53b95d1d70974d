#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

const double pi = 3.14159265358979323846;

// Keeps the rays of a tree of rays.
struct RayList : NoRecorder {
  struct Entry {
    RayKind kind;
    Ray ray;
    int depth;
    Color weight;
  };
  std::vector<Entry> rays;
  int too_deep_count = 0;

  void begin_ray(RayKind kind, const Ray& ray, int depth, const Color& weight) {
    rays.push_back({kind, ray, depth, weight});
  }
  void too_deep() { ++too_deep_count; }
};

RayList rays_of(const SceneBuilder& k, const Vec3& origin, const Vec3& direction) {
  const CompiledScene compiled(k.scene, 1);
  RayList list;
  Whitted<OwnRules, RayList>(compiled, list).radiance({origin, normalize(direction)}, compiled.around(origin));
  return list;
}

scene::MaterialId mirror(SceneBuilder& k, const Color& reflect, bool fresnel = false, double ior = 1) {
  scene::Material m;
  m.ambient = m.diffuse = grey(0);
  m.reflect = reflect, m.fresnel = fresnel, m.ior = ior;
  return k.material(m);
}

// What POV-Ray calls rgbt 1 with a Fresnel mirror of full strength and conserve_energy.
scene::MaterialId glass(SceneBuilder& k, double ior) {
  scene::Material m;
  m.ambient = m.diffuse = grey(0);
  m.reflect = white, m.refract = 1.0, m.ior = ior, m.fresnel = true;
  return k.material(m);
}

// In front of a white background.
double through(SceneBuilder& k, double z, int max_depth) {
  k.scene.background = white;
  k.scene.max_depth = max_depth;
  return Asked(k).radiance({0, 0, z}, {0, 0, 1}).r;
}

} // namespace

TEST_CASE("whitted: parallel mirrors sum a geometric series up to the depth") {
  SceneBuilder k;
  scene::Material m;
  m.ambient = m.diffuse = grey(0), m.emission = grey(0.1), m.reflect = grey(0.5);
  const auto half = k.material(m);
  k.add(k.plane({0, 0, 1}, -1).with(half));
  k.add(k.plane({0, 0, -1}, -1).with(half));
  k.scene.background = white;
  for (const int depth : {0, 1, 2, 8, 30}) {
    k.scene.max_depth = depth;
    // 0.1 (1 + ½ + ¼ + …), depth + 1 terms; beyond is black and not the background. 0.175 for depth 2.
    CHECK(Asked(k).radiance({0, 0, 0}, {0, 0, 1}).r == Approx(0.2 * (1 - std::pow(0.5, depth + 1))).epsilon(1e-14));
  }
}

TEST_CASE("whitted: a mirror's colour and a metal's tint weight the mirrored ray") {
  for (const double metallic : {0.0, 1.0}) {
    SceneBuilder k;
    scene::Material m;
    m.color = Color{1, 0.5, 0}, m.ambient = m.diffuse = grey(0);
    m.reflect = Color{0.5, 0.25, 0.125}, m.metallic = metallic;
    k.add(k.plane({0, 0, 1}, 0).with(k.material(m)));
    k.scene.background = white;
    // At 45° Φ = 0.0262831 by the formula of POV-Ray's manual.
    const Color c = Asked(k).radiance({0, 1, 1}, {0, -1, -1});
    CHECK(c.r == Approx(0.5));
    CHECK(c.g == Approx(0.25 * (1 - metallic * (1 - 0.0262831) * 0.5)).epsilon(1e-7));
    CHECK(c.b == Approx(0.125 * (1 - metallic * (1 - 0.026283103764))).epsilon(1e-7));
  }
}

TEST_CASE("whitted: a dielectric mirrors ((n − 1) / (n + 1))² head-on, and what the s and p formulas say at an angle") {
  SceneBuilder k;
  k.add(k.plane({0, 0, 1}, 0).with(mirror(k, white, true, 1.5)));
  k.scene.background = white;
  CHECK(Asked(k).radiance({0, 0, 1}, {0, 0, -1}).r == Approx(0.04).epsilon(1e-14));
  CHECK(Asked(k).radiance({0, 1, 1}, {0, -1, -1}).r == Approx(0.05023991101223595).epsilon(1e-13));
}

TEST_CASE("whitted: what a dielectric does not mirror it lets by") {
  SceneBuilder k;
  k.add(k.plane({0, 0, 1}, 0).with(glass(k, 1.5)));
  k.add(k.plane({0, 0, 1}, -10).with(k.glow({1, 0.5, 0})));
  k.scene.background = {0, 0, 1};
  const Color c = Asked(k).radiance({0, 0, 1}, {0, 0, -1});
  CHECK(c.r == Approx(0.96).epsilon(1e-14));
  CHECK(c.g == Approx(0.48).epsilon(1e-14));
  CHECK(c.b == Approx(0.04).epsilon(1e-14));
}

TEST_CASE("whitted: refraction turns a ray by Snell's law and a slab shifts it in parallel") {
  SceneBuilder k;
  scene::Material m;
  m.ambient = m.diffuse = grey(0), m.refract = 1.0, m.ior = 1.5;
  k.add(k.box({-10, -10, -1}, {10, 10, 0}).with(k.material(m)));
  const RayList list = rays_of(k, {0, 5, 5}, {0, -1, -1});
  REQUIRE(list.rays.size() == 3);
  // Inside at asin(sin 45° / 1.5) from the normal: its tangent is 0.5345224838248487.
  const Vec3 inside = list.rays[1].ray.direction;
  CHECK(list.rays[1].kind == RayKind::refracted);
  CHECK(inside.y / inside.z == Approx(0.5345224838248487).epsilon(1e-14));
  const Ray behind = list.rays[2].ray;
  CHECK(behind.direction.y == Approx(-std::sqrt(0.5)).epsilon(1e-14));
  CHECK(behind.direction.z == Approx(-std::sqrt(0.5)).epsilon(1e-14));
  CHECK(behind.origin.y == Approx(-0.5345224838248487).epsilon(1e-13));
  CHECK(behind.origin.z == Approx(-1).epsilon(1e-12));
  CHECK(list.rays[2].depth == 2);
}

TEST_CASE("whitted: beyond the critical angle all light is mirrored, with weight 1 and once") {
  // asin(1 / 1.5) = 41.81°.
  for (const auto& [degrees, is_total] : {std::pair{41.80, false}, {41.82, true}}) {
    SceneBuilder k;
    scene::Material m;
    m.color = grey(0.5), m.ambient = m.diffuse = grey(0), m.refract = 0.5, m.ior = 1.5, m.reflect = grey(0.25);
    k.add(k.box({-1000, -1000, -1}, {1000, 1000, 0}).with(k.material(m)));
    k.scene.max_depth = 1;
    const double a = degrees * pi / 180;
    const RayList list = rays_of(k, {0, 0, -0.5}, {0, std::sin(a), std::cos(a)});
    if (is_total) {
      REQUIRE(list.rays.size() == 3);
      CHECK(list.too_deep_count == 1); // the third, mirrored again at the other side
      CHECK(list.rays[1].kind == RayKind::total_reflection);
      CHECK(list.rays[1].weight == white);
      CHECK(list.rays[1].ray.direction.z == Approx(-std::cos(a)));
    } else {
      CHECK(list.rays[1].kind == RayKind::reflected);
      CHECK(list.rays[1].weight == grey(0.25));
    }
  }
}

TEST_CASE("whitted: a surface with equal indices on both sides bends nothing and costs no depth") {
  SceneBuilder k;
  scene::Material m;
  m.color = grey(0.5), m.ambient = m.diffuse = grey(0), m.refract = 1.0;
  const auto pane = k.material(m);
  for (int i = 1; i <= 8; ++i) k.add(k.plane({0, 0, 1}, -1.0 * i).with(pane));
  k.add(k.plane({0, 0, 1}, -10).with(k.glow(1)));
  k.scene.max_depth = 1;
  CHECK(Asked(k).radiance({0, 0, 1}, {0, 0, -1}).r == std::pow(0.5, 8));
  // But it takes a step to spare, as in POV-Ray.
  k.scene.max_depth = 0;
  CHECK(Asked(k).radiance({0, 0, 1}, {0, 0, -1}) == black);
}

TEST_CASE("whitted: ten thousand panes in a row overflow nothing") {
  SceneBuilder k;
  const auto pane = k.clear(1);
  for (int i = 1; i <= 10000; ++i) {
    scene::Disc disc;
    disc.normal = {0, 0, 1};
    k.add(k.shape(disc).at({0, 0, -1.0 * i}).with(pane));
  }
  k.scene.background = white;
  CHECK(Asked(k).radiance({0, 0, 1}, {0, 0, -1}) == white);
}

// The values were rendered by POV-Ray 3.7: concentric and overlapping spheres of clear glass with Fresnel mirrors, in
// front of a white background, seen from inside. Its max_trace_level is max_depth + 1.
TEST_CASE("whitted: nested and overlapping media as POV-Ray has them") {
  struct Ball {
    double z, radius, ior;
  };
  struct Case {
    Ball first, second;
    double eye;
    std::vector<double> by_depth; // from 1
  };
  const Case cases[] = {
      {{0, 2, 1.5}, {0, 1, 1.2}, 0, {0, 0.96, 0.96, 0.960474, 0.9984}},
      {{0, 1, 1.2}, {0, 2, 1.5}, 0, {0.948148, 0.959854, 0.960466, 0.997932, 0.998394}},
      {{0, 2, 1.5}, {1, 2, 1.2}, 0.5, {0.979492, 0.979492, 0.999087, 0.999087, 0.999982}},
      {{1, 2, 1.2}, {0, 2, 1.5}, 0.5, {0, 0.991736, 0.991736, 0.999576, 0.999576}},
      {{0, 2, 1.5}, {0, 1, 1.0}, -5, {0.04, 0.04, 0.076864, 0.9616, 0.961659}},
  };
  for (const Case& c : cases)
    for (std::size_t i = 0; i < c.by_depth.size(); ++i) {
      SceneBuilder k;
      for (const Ball& ball : {c.first, c.second})
        k.add(k.sphere(ball.radius).at({0, 0, ball.z}).with(glass(k, ball.ior)));
      CHECK(through(k, c.eye, static_cast<int>(i) + 1) == Approx(c.by_depth[i]).margin(1e-6));
    }
}

TEST_CASE("whitted: an opaque room around the eye is no medium, be it a solid or a shell") {
  SceneBuilder k;
  k.add(k.sphere(50).with(k.glow(1)));
  k.add(k.sphere(1).at({0, 0, 5}).with(glass(k, 1.5)));
  CHECK(through(k, 0, 3) == Approx(0.998464).margin(1e-6));
  SceneBuilder shell;
  shell.add(shell.subtract({shell.sphere(60), shell.sphere(50)}).with(shell.glow(1)));
  shell.add(shell.sphere(1).at({0, 0, 5}).with(glass(shell, 1.5)));
  CHECK(through(shell, 0, 3) == Approx(0.998464).margin(1e-6));
}

TEST_CASE("whitted: an eye within an open cylinder starts inside, one below a disc does not") {
  const auto first_branch = [](SceneBuilder& k) {
    const RayList list = rays_of(k, {0, 0, 0}, {0, 1, 1});
    return list.rays.size() > 1 ? list.rays[1].kind : RayKind::camera;
  };
  SceneBuilder tube;
  scene::Cylinder cylinder;
  cylinder.from = Vec3{0, -5, 0}, cylinder.to = Vec3{0, 5, 0}, cylinder.radius = 2, cylinder.open = true;
  tube.add(tube.shape(cylinder).with(tube.clear(1.5)));
  CHECK(first_branch(tube) == RayKind::total_reflection);
  SceneBuilder lid;
  scene::Disc disc;
  disc.normal = {0, 0, 1}, disc.radius = 5;
  lid.add(lid.shape(disc).at({0, 0, 2}).with(lid.clear(1.5)));
  CHECK(first_branch(lid) == RayKind::refracted);
  SceneBuilder water;
  water.add(water.plane({0, 0, 1}, 2).with(water.clear(1.5)));
  CHECK(first_branch(water) == RayKind::total_reflection);
}

TEST_CASE("whitted: a combination is one medium, with the index of its own material or of its leftmost part's") {
  const auto index_inside = [](const SceneBuilder& k) {
    const Vec3 d = rays_of(k, {0, 5, 5}, {0, -1, -1}).rays.at(1).ray.direction;
    return std::sqrt(0.5) / std::abs(d.y); // sin 45° / sin of the refracted angle
  };
  const auto slab = [](SceneBuilder& k) { return k.box({-10, -10, -1}, {10, 10, 0}); };
  {
    SceneBuilder k;
    k.add(k.subtract({slab(k), k.sphere(0.5).at({5, 5, 0}).with(k.clear(1.7))}).with(k.clear(1.5)));
    CHECK(index_inside(k) == Approx(1.5));
  }
  {
    SceneBuilder k;
    k.add(k.subtract({k.unite({slab(k).with(k.clear(1.3)), k.sphere(0.1).at({3, 3, 0})}),
                      k.sphere(0.5).at({5, 5, 0}).with(k.clear(1.3))}));
    CHECK(index_inside(k) == Approx(1.3));
  }
  {
    SceneBuilder k; // the leftmost part inherits from the group around
    const scene::Object solid = k.unite({slab(k), k.sphere(0.1).at({3, 3, 0}).with(k.clear(1.4))});
    k.add(k.group({solid}).with(k.clear(1.4)));
    CHECK(index_inside(k) == Approx(1.4));
  }
  {
    SceneBuilder k; // an opaque part does not count
    k.add(k.unite({k.sphere(0.1).at({0, 3, 0}).with(k.glow(1)), slab(k).with(k.clear(1.6))}));
    CHECK(index_inside(k) == Approx(1.6));
  }
}

TEST_CASE("whitted: the inside of a glass combination is entered and left once") {
  // A shell of glass: entered, left into the hollow, entered and left again.
  SceneBuilder k;
  k.add(k.subtract({k.sphere(2), k.sphere(1)}).with(k.clear(1.5)));
  const RayList list = rays_of(k, {0.3, 0, 5}, {0, 0, -1});
  REQUIRE(list.rays.size() == 5);
  for (std::size_t i = 1; i < 5; ++i) CHECK(list.rays[i].kind == RayKind::refracted);
  // In the middle of its way it runs through the hollow, where the index is 1: the angles at the outer and the inner
  // wall, by Snell: sin b = 0.15 / 1.5, the impact parameter 0.3 is an invariant of n r sin.
  const Ray hollow = list.rays[2].ray;
  CHECK(length(cross(hollow.origin, hollow.direction)) == Approx(0.3).epsilon(1e-13));
  const Ray wall = list.rays[1].ray;
  CHECK(length(cross(wall.origin, wall.direction)) == Approx(0.2).epsilon(1e-13));
  CHECK(length(cross(list.rays[4].ray.origin, list.rays[4].ray.direction)) == Approx(0.3).epsilon(1e-13));
}

TEST_CASE("whitted: recording changes nothing") {
  SceneBuilder k;
  scene::Material m;
  m.reflect = grey(0.3), m.refract = 0.6, m.ior = 1.4, m.fresnel = true, m.specular = 0.5;
  for (int i = 0; i < 5; ++i) k.add(k.sphere(0.6).at({1.0 * i, 0.2 * i, 0}).with(k.material(m)));
  k.add(k.plane({0, 1, 0}, -1));
  k.point_light({5, 5, 5});
  k.scene.background = {0.2, 0.3, 0.4};
  const CompiledScene compiled(k.scene, 1);
  NoRecorder none;
  RayList list;
  Whitted<> plain(compiled, none);
  Whitted<OwnRules, RayList> recorded(compiled, list);
  for (int i = 0; i < 100; ++i) {
    const Ray ray{{2, 1, 6}, normalize(Vec3{-2.5 + 0.05 * i, -1, -6})};
    CHECK(plain.radiance(ray, {}) == recorded.radiance(ray, {}));
  }
  CHECK(list.rays.size() > 100);
}

TEST_CASE("whitted: a lit convex solid shows no speckle, whatever its size, place and transform") {
  const auto solid = [](SceneBuilder& k, int which) -> scene::Object {
    if (which == 0) return k.sphere();
    if (which == 1) return k.shape(scene::Cone{});
    if (which == 2) return k.box({-1, -1, -1}, {1, 1, 1});
    return k.intersect({k.sphere(), k.plane({1, 1, 0}, 0.2)});
  };
  const Vec3 down{0.01, 0.02, -1}, to_light = normalize(Vec3{1, 1, 1});
  for (const double size : {1e-9, 1.0, 1e9})
    for (const Vec3& place : {Vec3{0, 0, 0}, Vec3{1e4, -2e4, 3e4}})
      for (int which = 0; which < 4; ++which) {
        SceneBuilder k;
        const auto sheared = k.chained({scene::ShearStep{.xy = 0.5, .zy = 0.3}, scene::RotateStep{{20, 30, 40}, {}},
                                        scene::ScaleStep{{size, size * 0.3, size}, {}}, scene::MoveStep{place * size}});
        k.add(k.group({solid(k, which)}).transformed(sheared));
        k.sun(-to_light);
        Asked asked(k);
        int lit = 0;
        for (int i = 0; i < 60; ++i)
          for (int j = 0; j < 60; ++j) {
            const Vec3 eye = (place + Vec3{0, 0, 5} + Vec3{-1.5 + 0.05 * i, -1.5 + 0.05 * j, 0}) * size;
            if (!asked.nearest(eye, down)) continue;
            if (dot(asked.surface(eye, down).normal, to_light) < 0.01) continue;
            CHECK(asked.radiance(eye, down).r > 0.001);
            ++lit;
          }
        CHECK(lit > 100);
      }
}

TEST_CASE("whitted: what a ray sees does not depend on those it travels with") {
  SceneBuilder k;
  scene::Material glass;
  glass.reflect = grey(0.3), glass.refract = 0.7, glass.ior = 1.4, glass.fresnel = true, glass.specular = 0.5;
  scene::Material film; // bends nothing, so that rays cross it
  film.refract = 0.8, film.reflect = grey(0.1), film.color = Color{0.9, 0.6, 0.7};
  for (int i = 0; i < 6; ++i)
    k.add(k.sphere(0.7).at({1.0 * i - 2.5, 0.1 * i, 0}).with(k.material(i % 2 ? glass : film)));
  k.add(k.plane({0, 1, 0}, -1));
  k.point_light({5, 5, 5});
  k.point_light({-3, 4, 6});
  k.scene.background = {0.2, 0.3, 0.4};
  const CompiledScene compiled(k.scene, 1);
  NoRecorder none;
  Whitted<> alone(compiled, none), together(compiled, none);
  for (const double spread : {0.0, 0.01, 0.3}) // from the same ray to rays that part
    for (int place = 0; place < 60; ++place) {
      std::array<Ray, bvh::packet_size> rays;
      std::array<Color, bvh::packet_size> seen;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const double x = -3 + 0.1 * place + spread * static_cast<double>(i % 4),
                     y = -0.4 + spread * static_cast<double>(i / 4);
        rays[i] = {{0.2, 1, 7}, normalize(Vec3{x, y, 0} - Vec3{0.2, 1, 7})};
      }
      const std::size_t count = place % 3 == 0 ? rays.size() : 5;
      together.radiance(std::span(rays).first(count), {}, seen);
      for (std::size_t i = 0; i < count; ++i) CHECK(seen[i] == alone.radiance(rays[i], {}));
    }
  CHECK(alone.counts().shadow == together.counts().shadow);
  CHECK(alone.counts().reflected == together.counts().reflected);
  CHECK(alone.counts().refracted == together.counts().refracted);
  CHECK(alone.counts().refracted > 1000);
}
