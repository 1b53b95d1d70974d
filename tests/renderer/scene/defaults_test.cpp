#include "renderer/scene/defaults.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::scene;

TEST_CASE("defaults: the camera sees the whole bounding sphere, from three-quarters above") {
  Scene scene;
  scene.size = {400, 400};
  const std::string note = assume_camera(scene, {{-1, -1, -1}, {1, 1, 1}});
  // R = √3, a = 50°: 1.1 √3 / sin 25° = 4.50821950 from the centre, along (0.5, 0.45, 1) / √1.4525.
  CHECK(length(scene.camera.at) == Approx(4.50821950).epsilon(1e-9));
  CHECK(scene.camera.at.x / scene.camera.at.z == Approx(0.5));
  CHECK(scene.camera.at.y / scene.camera.at.z == Approx(0.45));
  CHECK(scene.camera.look_at == Vec3{});
  CHECK(note == "no camera given: using one at [1.87, 1.683, 3.741] looking at [0, 0, 0]");
}

TEST_CASE("defaults: where there is nothing finite, or a single point, the view is the camera's own") {
  for (const Box3& box : {Box3{}, Box3{{1, 1, 1}, {1, 1, 1}}}) {
    Scene scene;
    scene.camera.at = {9, 9, 9};
    assume_camera(scene, box);
    CHECK(scene.camera.at == Camera{}.at);
  }
}

TEST_CASE("defaults: a sun shines down from behind the eye") {
  Scene scene;
  CHECK(assume_light(scene) == "no light given: added a sun with direction [-1, -2, -1.5]");
  REQUIRE(scene.lights.size() == 1);
  CHECK(std::get<SunLight>(scene.lights[0].source).direction == Vec3{-1, -2, -1.5});
}
