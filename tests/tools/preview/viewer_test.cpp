#include "renderer/image/image.hpp"
#include "tools/preview/camera_moves.hpp"
#include "tools/preview/viewer.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

using namespace rt;
using namespace rt::tools;
using namespace rt::tools::preview;
using Catch::Matchers::StartsWith;

namespace {

constexpr const char* ball = "size: [40, 30]\nsamples: 4\nsphere { material: red }\nplane { y: -1 }\n"
                             "camera { at: [0, 1, 6], look_at: [0, 0, 0] }\n";

std::unique_ptr<live::Document> document(const std::string& text) {
  return std::make_unique<live::Document>(lang::load_text(text, "scene.rtl", ".", {}), "scene.rtl");
}

/// Waits for the whole picture.
Pixels finished(Viewer& viewer) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  Pixels pixels;
  for (;;) {
    viewer.refresh();
    const bool is_whole = viewer.film().has_value();
    viewer.take(pixels);
    if (is_whole) return pixels;
    REQUIRE(std::chrono::steady_clock::now() < end);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// What a picture file has for it.
std::string ppm(const Film& film) {
  const std::string bytes = encode(film, ImageFormat::ppm, {8, {}});
  return bytes.substr(bytes.size() - film.color.size() * 3);
}

std::string rgb(const Pixels& pixels) {
  std::string bytes;
  for (const std::uint32_t code : pixels.argb)
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(code >> shift & 0xff);
  return bytes;
}

} // namespace

TEST_CASE("viewer: the picture is in the end that of the file, byte for byte") {
  std::atomic<int> changes = 0;
  Viewer viewer([&] { ++changes; });
  viewer.resize({40, 30});
  viewer.show(document(ball));
  const Pixels pixels = finished(viewer);
  CHECK(rgb(pixels) == ppm(document(ball)->render(RenderOptions{}).film));
  CHECK(viewer.fraction() == 1);
  CHECK(changes >= 2); // the coarse one, and the tiles of this
  Pixels again;
  CHECK_FALSE(viewer.take(again));
}

TEST_CASE("viewer: another size or camera is another picture, and a window may have any size") {
  Viewer viewer([] {});
  viewer.show(document(ball));
  viewer.resize({0, 0});
  CHECK(finished(viewer).argb.size() == 1);
  viewer.resize({41, 7});
  CHECK(finished(viewer).argb.size() == 41 * 7);
  const scene::Camera own = viewer.camera();
  viewer.move(orbited(own, 90, 0));
  auto turned = document(ball);
  View view = view_of(turned->scene());
  view.camera = orbited(own, 90, 0);
  view.size = {41, 7};
  CHECK(rgb(finished(viewer)) == ppm(turned->render(view, {}).film));
  scene::Camera blind = own;
  blind.at = blind.look_at;
  viewer.move(blind); // sees nothing: it stays where it is
  CHECK(viewer.camera().at == view.camera.at);
  viewer.reset_camera();
  CHECK(viewer.camera().at == own.at);
}

TEST_CASE("viewer: a camera that was moved stays where it is when the text changes, unless the scene's own does") {
  Viewer viewer([] {});
  viewer.resize({40, 30});
  viewer.show(document(ball));
  const Vec3 moved = orbited(viewer.camera(), 30, 10).at;
  viewer.move(orbited(viewer.camera(), 30, 10));
  viewer.show(document(std::string(ball) + "box {}"));
  CHECK(viewer.camera().at == moved);
  viewer.show(document("sphere {}\ncamera { at: [0, 3, 6] }"));
  CHECK(viewer.camera().at == Vec3{0, 3, 6});
}

TEST_CASE("viewer: it answers what the commands answer about the same ray") {
  Viewer viewer([] {});
  viewer.resize({40, 30});
  viewer.show(document(ball));
  explain::Question pixel;
  pixel.pixel = {{20, 15}};
  CHECK(viewer.probe(20.5, 15.5) == document(ball)->probe(pixel, {}));
  CHECK(viewer.why(20.5, 15.5) == document(ball)->why(pixel, {}));
  viewer.resize({80, 60}); // the scene's pixels are others
  CHECK_THAT(viewer.probe(41, 31), StartsWith("ray:"));
}
