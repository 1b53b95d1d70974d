#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

TEST_CASE("defaults: a camera is framed on the bounding box from three-quarters above") {
  const Loaded loaded = load("sphere { at: [1, 2, 3], radius: 2 }\nplane { y: -5 }\nambient: 1");
  REQUIRE(loaded.scene);
  REQUIRE(find(loaded, "N0001"));
  const scene::Camera& camera = loaded.scene->camera;
  CHECK(camera.look_at == Vec3{1, 2, 3}); // the plane is infinite: it does not count
  // R = 2√3; the picture is 800 × 600, so the smaller angle is the vertical one: tan(a/2) = 0.75 tan 25°.
  const double half = std::atan(0.75 * std::tan(25 * 3.14159265358979324 / 180));
  const double distance = 1.1 * 2 * std::sqrt(3.0) / std::sin(half);
  CHECK(length(camera.at - camera.look_at) == Approx(distance).epsilon(1e-13));
  const Vec3 direction = (camera.at - camera.look_at) / distance;
  CHECK(direction.x == Approx(0.5 / std::sqrt(1.4525)).epsilon(1e-13)); // 0.25 + 0.2025 + 1
  CHECK(direction.y == Approx(0.45 / std::sqrt(1.4525)).epsilon(1e-13));
  CHECK(loaded.scene->camera_origin.line == 0); // not written
}

TEST_CASE("defaults: an upright picture is framed by its horizontal angle") {
  const Loaded loaded = load("sphere {}\nsize: [300, 600]");
  REQUIRE(loaded.scene);
  const double distance = 1.1 * std::sqrt(3.0) / std::sin(25 * 3.14159265358979324 / 180);
  CHECK(length(loaded.scene->camera.at) == Approx(distance).epsilon(1e-13));
}

TEST_CASE("defaults: where nothing is finite, the view is fixed") {
  const Loaded loaded = load("plane { y: 0 }");
  REQUIRE(loaded.scene);
  CHECK(loaded.scene->camera.at == Vec3{0, 1, 6});
  CHECK(find(loaded, "N0001"));
  CHECK(load("").scene); // an empty file is an empty scene
}

TEST_CASE("defaults: a sun is added where there is neither light nor ambient") {
  const Loaded loaded = load("sphere {}");
  REQUIRE(loaded.scene);
  REQUIRE(loaded.scene->lights.size() == 1);
  CHECK(std::get<scene::SunLight>(loaded.scene->lights[0].source).direction == Vec3{-1, -2, -1.5});
  CHECK(loaded.scene->lights[0].origin.line == 0);
  CHECK(find(loaded, "N0002"));
  CHECK(find(loaded, "N0002")->severity == Severity::note);
  CHECK(load("sphere {}\nambient: 0.1").scene->lights.empty());
  CHECK_FALSE(find(load("sphere {}\nlight {}"), "N0002"));
  CHECK(load("sphere {}\ngroup { light {} }").scene->lights.size() == 1);
}

TEST_CASE("defaults: nothing is said where everything is written") {
  CHECK(load("sphere {}\ncamera {}\nlight { at: [0, 5, 5] }").diagnostics.empty());
}

TEST_CASE("defaults: a spot stands above the origin, and looks down at it") {
  const Loaded loaded = load("plane { y: 0 }\ncamera {}\nspot {}");
  INFO(report(loaded));
  CHECK(loaded.diagnostics.empty());
  REQUIRE(loaded.scene);
  const auto& spot = std::get<scene::SpotLight>(loaded.scene->lights.at(0).source);
  CHECK(spot.at == Vec3{0, 3, 0});
  CHECK(spot.look_at == Vec3{});
}
