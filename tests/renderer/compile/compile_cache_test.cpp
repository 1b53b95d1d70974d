#include "renderer/compile/compile.hpp"
#include "renderer/render/render.hpp"
#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cstring>

using namespace rt;
using namespace rt::tests;

namespace {

// A bit of everything: patterned floor, glass, an ellipsoid, a group placed twice, a combination, lights.
SceneBuilder many_things() {
  SceneBuilder k;
  k.scene.size = {64, 48};
  k.scene.camera.at = {3, 4, 9};
  k.scene.camera.look_at = {2, 0.5, 0};
  k.sun({-1, -2, -1});
  k.point_light({5, 5, 5}, grey(0.5));
  scene::Material floor;
  floor.color = k.checker(white, grey(0.2));
  floor.reflect = grey(0.2);
  const auto glass = k.clear(1.5, 0.9);
  k.add(k.plane({0, 1, 0}, -1).with(k.material(floor)));
  for (int i = 0; i < 60; ++i)
    k.add(
        k.sphere(0.3).at({i % 10 * 0.6, 0.7 * (i / 10), -0.4 * (i % 7)}).with(i % 3 == 0 ? glass : scene::no_material));
  k.add(k.sphere().at({-1, 0, 1}).transformed(k.scaled({1, 2, 0.5})).with(k.material(floor)));
  const scene::Object twice =
      k.group({k.sphere(0.4).at({0, 1, 0}), k.box({-0.2, -1, -0.2}, {0.2, 1, 0.2})}).at({4, 0, 2});
  k.add(twice);
  scene::Object second = twice;
  second.at = {5.5, 0, 2};
  k.add(second);
  k.add(k.subtract({k.box({-3, -1, 0}, {-1.5, 1, 1}), k.sphere(0.6).at({-2.2, 0, 1})}).with(glass));
  return k;
}

RenderOptions on_one_thread() {
  RenderOptions options;
  options.threads = 1;
  return options;
}

Film picture(const SceneBuilder& k, const CompiledScene& compiled) {
  return render(compiled, {k.scene.camera, k.scene.size, 1}, on_one_thread()).film;
}

bool have_equal_bytes(const Film& a, const Film& b) {
  return a.color.size() == b.color.size() &&
         std::memcmp(a.color.data(), b.color.data(), a.color.size() * sizeof(Rgb32)) == 0;
}

} // namespace

TEST_CASE("compile cache: pictures are the same bytes, however the scene is cut into parts") {
  const SceneBuilder k = many_things();
  const Film whole = render(k.scene, on_one_thread()).film;
  const auto n = static_cast<std::uint32_t>(k.scene.objects.size());
  const std::vector<std::vector<Part>> cuts{
      {}, {{0, n, 1}}, {{0, 30, 1}, {30, n, 2}}, {{5, 20, 1}, {40, 63, 2}}, {{1, 2, 1}, {2, 3, 2}, {62, 64, 3}}};
  for (const auto& parts : cuts) {
    CompileCache cache(1);
    CHECK(have_equal_bytes(whole, picture(k, CompiledScene(k.scene, parts, cache))));
  }
}

TEST_CASE("compile cache: what did not change is not built again, and pictures show what did") {
  SceneBuilder k = many_things();
  const auto n = static_cast<std::uint32_t>(k.scene.objects.size());
  const std::vector<Part> parts{{0, 40, 7}, {40, n, 8}};
  CompileCache cache(1);
  { const CompiledScene first(k.scene, parts, cache); }
  CHECK(cache.counts().parts_built == 2);
  CHECK(cache.counts().objects_built == n);

  // A new material, a new pattern and a new thing in front of everything.
  scene::Material painted;
  painted.color = k.checker({1, 0, 0}, {0, 0, 1});
  k.add(k.sphere(0.8).at({2.4, 2, 5}).with(k.material(painted)));
  const CompiledScene second(k.scene, parts, cache);
  CHECK(cache.counts().parts_built == 2);
  CHECK(cache.counts().objects_reused == n);
  CHECK(have_equal_bytes(render(k.scene, on_one_thread()).film, picture(k, second)));

  // The first part is another one now, the second has moved in the list.
  k.scene.objects.erase(k.scene.objects.begin() + 3);
  const std::vector<Part> changed{{0, 39, 9}, {39, n - 1, 8}};
  const CompiledScene third(k.scene, changed, cache);
  CHECK(cache.counts().parts_built == 3);
  CHECK(have_equal_bytes(render(k.scene, on_one_thread()).film, picture(k, third)));
}

TEST_CASE("compile cache: the path to an object is the same in a part as outside") {
  const SceneBuilder k = many_things();
  Asked whole(k);
  CompileCache cache(1);
  const std::vector<Part> parts{{10, 64, 1}};
  const CompiledScene cut(k.scene, parts, cache);
  TraceScratch scratch;
  for (int i = 0; i < 200; ++i) {
    const Vec3 origin{0.05 * i - 3, 1.5, 8}, direction{0.01 * (i % 7), -0.1 - 0.01 * (i % 13), -1};
    const RayHit hit = whole.nearest(origin, direction);
    if (!hit) continue;
    const RayHit again = cut.nearest({origin, direction}, {}, scratch);
    REQUIRE(again);
    CHECK(again.t == hit.t);
    CHECK(cut.path(again) == whole.compiled.path(hit));
  }
}
