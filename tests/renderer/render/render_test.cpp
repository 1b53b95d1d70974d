#include "renderer/render/render.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

namespace {

using namespace rt;

// A red unit sphere resting on a grey plane, seen and lit from +z.
scene::Scene sphere_on_plane() {
  tests::SceneBuilder build;
  scene::Scene& s = build.scene;
  s.size = {64, 48};
  s.camera.at = {0, 1, 6};
  s.camera.look_at = {0, 1, 0};
  s.ambient = grey(0.1);
  s.background = {0, 0, 1};
  build.add(build.sphere().at({0, 1, 0}).with(build.material(Color{1, 0, 0})));
  build.add(build.shape(scene::Plane{}));
  build.point_light({0, 1, 6});
  return std::move(s);
}

} // namespace

TEST_CASE("render: a sphere on a plane, its light at the eye") {
  scene::Scene s = sphere_on_plane();
  s.size = {65, 49}; // so that there is a middle pixel
  RenderOptions options;
  options.layers = true;
  const Rendered r = render(s, options);
  REQUIRE(r.is_complete);
  const std::size_t middle = r.film.index(32, 24);
  // In the middle n·l = 1: ambient 0.1 and diffuse 0.8 of red.
  CHECK(r.film.color[middle].r == Approx(0.9).epsilon(1e-6));
  CHECK(r.film.color[middle].g == 0);
  CHECK(r.film.depth[middle] == Approx(5).epsilon(1e-14));
  CHECK(r.film.object_id[middle] == 1);
  CHECK(r.film.normal[middle].z == 1);
  // The top left corner sees the sky, the bottom one the plane, 1 below the eye.
  CHECK(r.film.color[0].b == 1);
  CHECK(r.film.object_id[0] == 0);
  const std::size_t corner = r.film.index(0, 48);
  CHECK(r.film.object_id[corner] == 2);
  CHECK(r.film.position[corner].y == 0);
  CHECK(r.film.normal[corner].y == 1);
}

TEST_CASE("render: any number of threads gives the same bytes") {
  const scene::Scene s = sphere_on_plane();
  RenderOptions options;
  options.threads = 1;
  const Film one = render(s, options).film;
  for (const int threads : {2, 5}) {
    options.threads = threads;
    const Film film = render(s, options).film;
    CHECK(std::equal(one.color.begin(), one.color.end(), film.color.begin(),
                     [](const Rgb32& a, const Rgb32& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }));
  }
}

TEST_CASE("render: a crop is that part of the whole picture") {
  const scene::Scene s = sphere_on_plane();
  RenderOptions options;
  const Film whole = render(s, options).film;
  options.crop = PixelRect{7, 5, 50, 41};
  const Film part = render(s, options).film;
  REQUIRE(part.width == 43);
  REQUIRE(part.height == 36);
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      CHECK(part.color[part.index(x, y)].r == whole.color[whole.index(x + 7, y + 5)].r);
}

TEST_CASE("render: a stop that is already set leaves the picture incomplete") {
  const std::atomic<bool> stop = true;
  RenderOptions options;
  options.stop = &stop;
  CHECK_FALSE(render(sphere_on_plane(), options).is_complete);
}

TEST_CASE("render: a stop ends even a pixel that would take for ever") {
  // Panes that mirror and let by, one behind the other: the rays of one pixel double with every level.
  tests::SceneBuilder build;
  scene::Scene& s = build.scene;
  s.size = {64, 48};
  s.max_depth = 60;
  scene::Material half;
  half.reflect = grey(0.5);
  half.refract = 0.5;
  for (int i = 0; i < 6; ++i) build.add(build.plane({0, 0, 1}, 4 - i).with(build.material(half)));
  std::atomic<bool> stop = false;
  RenderOptions options;
  options.stop = &stop;
  const auto start = std::chrono::steady_clock::now();
  std::jthread stopper([&stop] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop = true;
  });
  CHECK_FALSE(render(s, options).is_complete);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
}

TEST_CASE("render: each tile is shown once, with its values in it") {
  scene::Scene s = sphere_on_plane();
  RenderOptions options;
  options.threads = 3;
  options.crop = PixelRect{5, 7, 60, 46};
  std::vector<int> shown(std::size_t{55 * 39}, 0);
  std::vector<Rgb32> seen(shown.size());
  options.on_tile = [&](const Film& film, const PixelRect& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        ++shown[film.index(x, y)];
        seen[film.index(x, y)] = film.color[film.index(x, y)];
      }
  };
  const Film film = render(s, options).film;
  CHECK(std::all_of(shown.begin(), shown.end(), [](int times) { return times == 1; }));
  CHECK(std::equal(seen.begin(), seen.end(), film.color.begin(), film.color.end(),
                   [](const Rgb32& a, const Rgb32& b) { return a.r == b.r && a.g == b.g && a.b == b.b; }));
}

TEST_CASE("render: no tile is shown of a picture that was stopped before it began") {
  const std::atomic<bool> stop = true;
  RenderOptions options;
  options.stop = &stop;
  int tiles = 0;
  options.on_tile = [&](const Film&, const PixelRect&) { ++tiles; };
  render(sphere_on_plane(), options);
  CHECK(tiles == 0);
}

TEST_CASE("render: what a tile's sink throws ends the picture") {
  RenderOptions options;
  options.on_tile = [](const Film&, const PixelRect&) { throw std::runtime_error("no room"); };
  CHECK_THROWS_WITH(render(sphere_on_plane(), options), "no room");
}

TEST_CASE("render: one ray for each sample is counted, and one to the light for each lit surface at least") {
  scene::Scene s = sphere_on_plane();
  s.samples = 4;
  const RayCounts rays = render(s, {}).statistics.rays;
  CHECK(rays.camera == 64 * 48 * 4);
  CHECK(rays.shadow > 0);
  CHECK(rays.shadow <= rays.camera);
  CHECK(rays.reflected == 0);
  CHECK(rays.refracted == 0);
  CHECK(rays.total() == rays.camera + rays.shadow);
}
