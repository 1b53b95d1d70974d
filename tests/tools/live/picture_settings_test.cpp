#include "tools/live/picture_settings.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::tools::live;

namespace {

TEST_CASE("picture settings: lists of whole numbers have the given count and separator") {
  CHECK(parse_numbers("800x600", 'x', 2) == std::vector{800, 600});
  CHECK(parse_numbers("1,-2,3,4", ',', 4) == std::vector{1, -2, 3, 4});
  for (const char* text : {"", "800", "800x", "x600", "800x600x1", "800X600", "800 x 600", "8.5x6", "99999999999x1"})
    CHECK_FALSE(parse_numbers(text, 'x', 2));
}

TEST_CASE("picture settings: what is read overrides the scene's own, and nothing else does") {
  PictureSettings settings;
  CHECK(settings.set("size", "40x30") == "");
  CHECK(settings.set("max_depth", "7") == "");
  CHECK(settings.set("noise", "0.02") == "");
  CHECK(settings.set("noise", "0") == "takes a number above 0, not `0`");
  CHECK(settings.set("noise", "loud") == "takes a number above 0, not `loud`");
  scene::Scene scene;
  scene.samples = 9;
  settings.apply_to(scene);
  CHECK(scene.size == scene::Resolution{40, 30});
  CHECK(scene.max_depth == 7);
  CHECK(scene.noise == 0.02);
  CHECK(scene.samples == 9);
}

TEST_CASE("picture settings: what a scene could not say is refused, and changes nothing") {
  PictureSettings settings;
  CHECK(settings.set("size", "40") == "takes width and height, as in 800x600, not `40`");
  CHECK(settings.set("size", "0x30") == "takes whole numbers from 1 to 65536, not 0");
  CHECK(settings.set("samples", "many") == "takes a whole number, not `many`");
  CHECK(settings.set("seed", "-1") == "takes whole numbers from 0 to 2147483647, not -1");
  CHECK(settings.set("mode", "radiosity") == "takes one of whitted, path, occlusion, not `radiosity`");
  CHECK(settings == PictureSettings{});
}

TEST_CASE("picture settings: what was written for one mode does not count in the other") {
  PictureSettings settings;
  CHECK(settings.set("mode", "path") == "");
  CHECK(settings.set("seed", "5") == "");
  scene::Scene scene;
  scene.samples = 9, scene.max_depth = 2;
  settings.apply_to(scene);
  CHECK(scene.mode == scene::Mode::path);
  CHECK(scene.seed == 5);
  CHECK(scene::sample_count(scene) == 64);
  CHECK(scene::depth_limit(scene) == 64);
  scene.samples = 10; // of its own mode
  settings.apply_to(scene);
  CHECK(scene.samples == 10);
}

TEST_CASE("picture settings: samples are a square number in Whitted's mode, and any in path mode") {
  PictureSettings settings;
  CHECK(settings.set("samples", "3") == "");
  scene::Scene scene;
  CHECK_THROWS_WITH(settings.apply_to(scene), Catch::StartsWith("--samples cannot be 3: "));
  scene.mode = scene::Mode::path;
  settings.apply_to(scene);
  CHECK(scene.samples == 3);
}

} // namespace
