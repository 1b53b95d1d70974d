#include "lang/load.hpp"
#include "tools/preview/camera_moves.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::tools::preview;

namespace {

/// At [0, 0, 5], looking at the origin: its right is x, its up is y.
scene::Camera ahead() {
  scene::Camera camera;
  camera.at = {0, 0, 5};
  return camera;
}

bool is_near(const Vec3& a, const Vec3& b) {
  return length(a - b) < 1e-12;
}

} // namespace

TEST_CASE("camera moves: the eye goes round what it looks at, as far away as before") {
  CHECK(is_near(orbited(ahead(), 90, 0).at, {5, 0, 0}));
  CHECK(is_near(orbited(ahead(), -90, 0).at, {-5, 0, 0}));
  CHECK(is_near(orbited(ahead(), 180, 0).at, {0, 0, -5}));
  const double half = 5 * std::sqrt(0.5);
  CHECK(is_near(orbited(ahead(), 0, 45).at, {0, half, half}));
  CHECK(is_near(orbited(ahead(), 90, -45).at, {half, -half, 0}));
  CHECK(orbited(ahead(), 90, 0).look_at == Vec3{});
}

TEST_CASE("camera moves: the eye stops a degree from the poles, and one that is nearer is not pushed away") {
  const double degree = std::acos(-1) / 180;
  const scene::Camera top = orbited(ahead(), 0, 200);
  CHECK(is_near(top.at, {0, 5 * std::cos(degree), 5 * std::sin(degree)}));
  scene::Camera steep = ahead();
  steep.at = {0, 5 * std::cos(degree / 2), 5 * std::sin(degree / 2)};
  CHECK(is_near(orbited(steep, 0, 10).at, steep.at));
  CHECK(orbited(steep, 0, -10).at.y < steep.at.y);
}

TEST_CASE("camera moves: a pan counts widths of the picture") {
  scene::Camera camera = ahead();
  camera.fov = 90; // five away the picture is 2·5·tan 45° = 10 wide
  const scene::Camera moved = panned(camera, 0.1, -0.2);
  CHECK(is_near(moved.at, {1, -2, 5}));
  CHECK(is_near(moved.look_at, {1, -2, 0}));
  camera.projection = scene::Projection::orthographic;
  camera.width = 4;
  CHECK(is_near(panned(camera, 0.25, 0).look_at, {1, 0, 0}));
}

TEST_CASE("camera moves: a zoom multiplies the distance, or the width that is seen") {
  CHECK(is_near(zoomed(ahead(), 0.5).at, {0, 0, 2.5}));
  CHECK(zoomed(ahead(), 0.5).width == 2);
}

TEST_CASE("camera moves: the text of a camera is read as that camera") {
  CHECK(camera_text(scene::Camera{}) == "camera { at: [0, 1, 6], look_at: [0, 0, 0] }");
  scene::Camera camera = orbited(ahead(), 37, 11);
  camera.fov = 33.3;
  camera.up = {0, 2, 0.5};
  camera.projection = scene::Projection::orthographic;
  camera.width = 7.5;
  camera.aperture = 0.1;
  const lang::Loaded loaded = lang::load_text(camera_text(camera) + "\nsphere {}", "scene", ".", {});
  REQUIRE(loaded.scene);
  const scene::Camera& read = loaded.scene->camera;
  for (const scene::Field& field : fields(&camera)) {
    INFO(field.name);
    CHECK(field.get(&read) == field.get(&camera));
  }
}
