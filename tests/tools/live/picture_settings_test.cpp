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
  scene::Scene scene;
  scene.samples = 9;
  settings.apply_to(scene);
  CHECK(scene.size == scene::Resolution{40, 30});
  CHECK(scene.max_depth == 7);
  CHECK(scene.samples == 9);
}

TEST_CASE("picture settings: what a scene could not say is refused, and changes nothing") {
  PictureSettings settings;
  CHECK(settings.set("size", "40") == "takes width and height, as in 800x600, not `40`");
  CHECK(settings.set("size", "0x30") == "takes whole numbers from 1 to 65536, not 0");
  CHECK(settings.set("samples", "many") == "takes a whole number, not `many`");
  CHECK(settings.set("samples", "3").starts_with("cannot be 3: "));
  CHECK(settings == PictureSettings{});
}

} // namespace
