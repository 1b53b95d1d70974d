#include "renderer/render/render.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tests;

namespace {

using Path = std::vector<std::uint32_t>;

// n³ small spheres in the unit cube: enough to be worth an instance.
std::vector<scene::Object> grid(SceneBuilder& k, int n) {
  std::vector<scene::Object> members;
  const scene::ShapeRef ball = k.Builder::shape(scene::Sphere{0.25 / n});
  for (int i = 0; i < n * n * n; ++i) {
    scene::Object o;
    o.shape = ball;
    o.at = Vec3{i % n + 0.5, i / n % n + 0.5, i / n / n + 0.5} / n;
    members.push_back(o);
  }
  return members;
}

scene::Object like(const scene::Object& o, const Vec3& at, scene::TransformId turn = scene::no_transform) {
  scene::Object copy = o;
  copy.at = at, copy.transform = turn;
  return copy;
}

} // namespace

TEST_CASE("instances: a shared group is hit in each of its places, and knows which it is") {
  SceneBuilder k;
  k.add(k.sphere(0.5).at({-20, 0, 0}));
  const scene::Object cube = k.group(grid(k, 16));
  k.add(like(cube, {0, 0, 0}));
  k.add(k.sphere(0.5).at({20, 0, 0}));
  k.add(like(cube, {10, 0, 0}));
  k.add(k.sphere(0.5).at({30, 0, 0}));
  Asked asked(k);
  const double half = 0.5 / 16, radius = 0.25 / 16;
  for (const auto& [x, order, path] : {std::tuple{half, 1u, Path{1, 0}},
                                       {10 + half, 4098u, Path{3, 0}},
                                       {20.0, 4097u, Path{2}},
                                       {30.0, 8194u, Path{4}},
                                       {-20.0, 0u, Path{0}}}) {
    const double y = path.size() > 1 ? half : 0;
    const RayHit hit = asked.nearest({x, y, -1}, {0, 0, 1});
    CHECK(hit.t == (path.size() > 1 ? 1 + half - radius : 0.5));
    CHECK(asked.compiled.path(hit) == path);
    CHECK(asked.surface({x, y, -1}, {0, 0, 1}).order == order);
  }
  // The last sphere of the second cube.
  const RayHit last = asked.nearest({11 - half, 1 - half, 5}, {0, 0, -1});
  CHECK(asked.compiled.path(last) == Path{3, 4095});
}

TEST_CASE("instances: equal distances go to the one declared first") {
  SceneBuilder k;
  const scene::Object cube = k.group(grid(k, 16));
  k.add(like(cube, {0, 0, 0}));
  k.add(like(cube, {0, 0, 0}));
  k.add(like(cube, {8, 0, 0}));
  k.add(like(cube, {8, 0, 0}));
  Asked asked(k);
  const double half = 0.5 / 16;
  CHECK(asked.compiled.path(asked.nearest({half, half, -1}, {0, 0, 1})) == Path{0, 0});
  CHECK(asked.compiled.path(asked.nearest({8 + half, half, -1}, {0, 0, 1})) == Path{2, 0});
}

TEST_CASE("instances: nested, sheared and far away they are where they should be") {
  SceneBuilder k;
  const scene::Object cube = k.group(grid(k, 16));
  const scene::Object pair = k.group({like(cube, {0, 0, 0}), like(cube, {4, 0, 0})});
  const auto sheared = k.chained({scene::ShearStep{.xy = 1}});
  k.add(like(pair, {0, 0, 0}));
  k.add(like(pair, {0, 100, 0}, sheared)); // x' = x + y, y = 100 and more
  k.add(like(pair, {1048576, 0, 0}));
  Asked asked(k);
  const double half = 0.5 / 16, radius = 0.25 / 16;
  CHECK(asked.nearest({4 + half, half, -1}, {0, 0, 1}).t == 1 + half - radius);
  // The chain comes after `at`: the first ball of the second cube stands at x = 4 + ½/16 + y.
  const double y = 100 + half;
  const RayHit hit = asked.nearest({4 + half + y, y, -1}, {0, 0, 1});
  CHECK(hit.t == Approx(1 + half - radius).epsilon(1e-13));
  CHECK(asked.compiled.path(hit) == Path{1, 1, 0});
  const RayHit far = asked.nearest({1048576 + half, half, -1}, {0, 0, 1});
  CHECK(far.t == Approx(1 + half - radius).epsilon(1e-13));
  CHECK(asked.compiled.path(far) == Path{2, 0, 0});
}

TEST_CASE("instances: seen from a million away") {
  SceneBuilder k;
  const scene::Object cube = k.group(grid(k, 16));
  k.add(like(cube, {0, 0, 0}));
  k.add(like(cube, {8, 0, 0}));
  Asked asked(k);
  const double half = 0.5 / 16, radius = 0.25 / 16;
  CHECK(asked.nearest({8 + half, half, -1048576}, {0, 0, 1}).t == Approx(1048576 + half - radius).epsilon(1e-15));
  CHECK_FALSE(asked.nearest({8 + 2 * half, half, -1048576}, {0, 0, 1}));
}

TEST_CASE("instances: a doubling chain of groups has as many leaves as it should") {
  SceneBuilder k;
  scene::Object thing = k.group(grid(k, 8)); // 512 leaves within the unit cube
  for (int level = 0; level < 40; ++level)
    thing = k.group({like(thing, {0, 0, 0}), like(thing, {0, 0, std::ldexp(2.0, level)})});
  k.add(thing);
  k.add(k.sphere(1).at({-10, 0, 0}));
  Asked asked(k);
  const double half = 0.5 / 8, radius = 0.25 / 8;
  CHECK(asked.nearest({half, half, -1}, {0, 0, 1}).t == 1 + half - radius);
  // The order of what comes after: 512 · 2⁴⁰.
  CHECK(asked.surface({-10, 0, -5}, {0, 0, 1}).order == std::uint64_t{512} << 40);
  // The last cube, from behind.
  const double end = std::ldexp(2.0, 40) - 2 + 1;
  const RayHit last = asked.nearest({half, half, end + 1}, {0, 0, -1});
  CHECK(last.t == Approx(1 + half - radius).epsilon(1e-3)); // an ulp of 2⁴¹ is 2⁻¹¹
  CHECK(asked.compiled.path(last).size() == 42);
}

TEST_CASE("instances: members inherit the material of their place") {
  SceneBuilder k;
  const auto red = k.glow({1, 0, 0}), blue = k.glow({0, 0, 1});
  auto members = grid(k, 16);
  members[0].material = k.glow({0, 1, 0});
  const scene::Object cube = k.group(members);
  scene::Object a = like(cube, {0, 0, 0}), b = like(cube, {4, 0, 0});
  a.material = red;
  k.add(a);
  k.add(k.group({b}).with(blue));
  Asked asked(k);
  const double half = 0.5 / 16;
  CHECK(asked.radiance({half, half, -1}, {0, 0, 1}) == Color{0, 1, 0});
  CHECK(asked.radiance({3 * half, half, -1}, {0, 0, 1}) == Color{1, 0, 0});
  CHECK(asked.radiance({4 + half, half, -1}, {0, 0, 1}) == Color{0, 1, 0});
  CHECK(asked.radiance({4 + 3 * half, half, -1}, {0, 0, 1}) == Color{0, 0, 1});
}

TEST_CASE("instances: a pattern stays in the space of whoever wrote the material") {
  SceneBuilder k;
  scene::Material m;
  m.color = k.checker({1, 0, 0}, {0, 0, 1});
  m.emission = grey(1), m.diffuse = m.ambient = grey(0);
  const auto checked = k.material(m);
  const scene::Object cube = k.group(grid(k, 16));
  // The cube from 0 to 1 lies in one cell of the scene's checker, whichever place it has; the one that writes the
  // material itself takes its pattern along.
  scene::Object inner = like(cube, {0.5, 0, 0}), outer = like(cube, {3.5, 0, 0});
  k.add(k.group({inner}).with(checked)); // x from 0.5 to 1.5: two cells
  outer.material = checked;              // x from 0 to 1 in its own space: one cell
  k.add(outer);
  Asked asked(k);
  const double half = 0.5 / 16;
  CHECK(asked.radiance({0.5 + half, half, -1}, {0, 0, 1}) == Color{1, 0, 0});
  CHECK(asked.radiance({1.5 - half, half, -1}, {0, 0, 1}) == Color{0, 0, 1});
  CHECK(asked.radiance({3.5 + half, half, -1}, {0, 0, 1}) == Color{1, 0, 0});
  CHECK(asked.radiance({4.5 - half, half, -1}, {0, 0, 1}) == Color{1, 0, 0});
}

TEST_CASE("instances: the same picture as from copies") {
  const auto build = [](bool shares) {
    SceneBuilder k;
    k.scene.size = {96, 72};
    k.scene.camera.at = {3, 3, 8};
    k.scene.camera.look_at = {1.5, 0.5, 0.5};
    k.scene.ambient = grey(0.1);
    const auto glass = k.material([] {
      scene::Material m;
      m.refract = 0.8, m.ior = 1.5, m.reflect = grey(0.2), m.specular = 0.5;
      return m;
    }());
    k.add(k.plane({0, 1, 0}, 0));
    const scene::Object shared = k.group(grid(k, 12));
    const auto turn = k.rotated({0, 30, 10});
    for (int i = 0; i < 3; ++i) {
      scene::Object o =
          like(shares ? shared : k.group(grid(k, 12)), {1.25 * i, 0.25, 0}, i == 1 ? turn : scene::no_transform);
      if (i == 2) o.material = glass;
      k.add(o);
    }
    k.point_light({5, 10, 10});
    return k.scene;
  };
  RenderOptions options;
  options.layers = true;
  const Film instances = render(build(true), options).film, copies = render(build(false), options).film;
  CHECK(instances.object_id == copies.object_id);
  double worst_depth = 0, worst_color = 0;
  for (std::size_t i = 0; i < copies.color.size(); ++i) {
    if (copies.object_id[i] == 0) continue;
    worst_depth = std::max(worst_depth, std::abs(instances.depth[i] - copies.depth[i]));
    worst_color = std::max(worst_color, std::abs(double{instances.color[i].r} - double{copies.color[i].r}));
  }
  CHECK(worst_depth < 1e-12);
  CHECK(worst_color < 1e-6);
}
