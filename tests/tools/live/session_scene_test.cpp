#include "tests/support/session_driver.hpp"
#include "tools/live/session_scene.hpp"

#include <catch2/catch.hpp>

#include <atomic>

using namespace rt;
using namespace rt::tools;

namespace {

const explain::Question middle{.pixel = std::array{24, 18}};

struct LiveSession {
  tests::SessionDriver driver;
  live::SessionScene scene{driver.session, {}};

  std::vector<Rgb32> picture() { return scene.render({.size = scene::Resolution{48, 36}}, {}).film.color; }
};

TEST_CASE("session scene: a picture follows every change, and is the whole scene's") {
  LiveSession live;
  live.driver.say("camera { at: [0, 0, 10] }");
  live.driver.say("ball = sphere { material: red }");
  live.driver.say("ball");
  const std::vector<Rgb32> small = live.picture();
  CHECK(tests::are_equal(small, tests::picture(live.driver.session.scene())));
  live.driver.session.set("ball.radius", "2");
  const std::vector<Rgb32> large = live.picture();
  CHECK_FALSE(tests::are_equal(large, small));
  CHECK(tests::are_equal(large, tests::picture(live.driver.session.scene())));
  live.driver.session.undo();
  CHECK(tests::are_equal(live.picture(), small));
}

TEST_CASE("session scene: answers name lines of the document as it would be saved, and follow its changes") {
  LiveSession live;
  live.driver.say("camera {at:[0,0,10]\n,look_at:[0,0,0]}");
  live.driver.say("sphere{}");
  const live::PictureSettings settings{.size = scene::Resolution{48, 36}};
  const std::string first = live.scene.document(settings).probe(middle, {});
  // The camera takes four lines, so that the sphere stands on the fifth.
  CHECK(live.driver.session.formatted() == "camera {\n  at: [0, 0, 10]\n  look_at: [0, 0, 0]\n}\nsphere {}\n");
  CHECK_THAT(first, Catch::Contains("sphere (session:5)"));
  live.driver.say("box { at: [0, 0, 5] }");
  CHECK_THAT(live.scene.document(settings).probe(middle, {}), Catch::Contains("box (session:6)"));
}

TEST_CASE("session scene: the document is loaded once for a version and its settings") {
  LiveSession live;
  live.driver.say("sphere {}");
  const scene::Scene* const first = &live.scene.document().scene();
  const Vec3 place = first->camera.at;
  CHECK(&live.scene.document().scene() == first);
  CHECK(live.scene.document({.size = scene::Resolution{4, 4}}).scene().size == scene::Resolution{4, 4});
  CHECK(live.scene.document().scene().size == scene::Resolution{800, 600});
  CHECK(live.scene.document().scene().camera.at == place);
}

TEST_CASE("session scene: loading that is stopped leaves a document without a scene, and is tried again") {
  tests::SessionDriver driver;
  driver.say("for i in 1..1000 { sphere { at: [i, 0, 0] } }");
  std::atomic<bool> stop = true;
  lang::LoadOptions options;
  options.stop = &stop;
  live::SessionScene scene(driver.session, options);
  CHECK_FALSE(scene.document().has_scene());
  stop = false;
  REQUIRE(scene.document().has_scene());
  CHECK(scene.document().scene().objects.size() == 1000);
}

} // namespace
