#include "tests/support/session_driver.hpp"

using rt::lang::Session;
using rt::lang::SessionResult;
using namespace rt::tests;

TEST_CASE("session: comments stay where they are") {
  SessionDriver talk;
  talk.say("// a ball\nball = sphere {} // round\n// and that is it");
  talk.say("ball");
  CHECK(talk.session.text() == "// a ball\nball = sphere {} // round\n// and that is it\nball\n");
  REQUIRE(talk.session.set("ball.radius", "2").is_accepted);
  CHECK(talk.session.text() == "// a ball\nball = sphere { radius: 2 } // round\n// and that is it\nball\n");
}

TEST_CASE("session: a file that is loaded is its document, word by word, and makes the same picture") {
  const Folder folder;
  folder.write("colors.rtl", "rust = #b7410e\n");
  const std::string text =
      "// A scene\nuse \"colors.rtl\" as colors\n\nsize: [64, 48]\n\n// things\n"
      "for i in 0..4 { sphere { at: [i, 0, 0], radius: 0.4, material: colors.rust } }\n"
      "table { width: 2 } // uses what comes later\n\ndef table(width = 1) {\n  box { size: [width, 0.1, width] }\n}\n"
      "sphere { at: [0, 1, 0] }\nsphere { at: [1, 1, 0] }\nsphere { at: [2, 1, 0] }\n";
  const std::string path = folder.write("scene.rtl", text);
  SessionDriver talk;
  talk.say("box {}");
  REQUIRE(talk.session.load(path).is_accepted);
  CHECK(talk.session.text() == text);
  const rt::lang::Loaded loaded = rt::lang::load_file(path, {});
  REQUIRE(loaded.scene);
  CHECK(talk.count() == loaded.scene->objects.size());
  CHECK(are_equal(picture(talk.session.scene()), picture(*loaded.scene)));
}

TEST_CASE("session: things of a loaded file can be changed like others") {
  const Folder folder;
  const std::string path =
      folder.write("scene.rtl", "r = 0.5\nsphere { radius: r, at: [0, 0, 0] }\nsphere { radius: r, at: [1, 0, 0] }\n"
                                "sphere { radius: r, at: [2, 0, 0] }\n");
  SessionDriver talk;
  REQUIRE(talk.session.load(path).is_accepted);
  talk.say(".move(y: 1)");
  CHECK(talk.count() == 3);
  CHECK(talk.at(2) == rt::Vec3{2, 1, 0});
  CHECK(talk.at(1) == rt::Vec3{1, 0, 0});
  talk.say("r = 2");
  for (std::size_t i = 0; i < 3; ++i) CHECK(talk.radius(i) == 2);
  const SessionResult refused = talk.refuse("r = -1");
  CHECK(rt::lang::render(refused.diagnostics.front(), talk.session.sources(), false).find("scene.rtl:2:") !=
        std::string::npos);
}

TEST_CASE("session: a file with mistakes is not loaded, and all of them are reported") {
  const Folder folder;
  const std::string path = folder.write("scene.rtl", "sphere { raduis: 1 }\nbox { sizze: 2 }\n");
  SessionDriver talk;
  talk.say("plane {}");
  const SessionResult result = talk.session.load(path);
  CHECK_FALSE(result.is_accepted);
  CHECK(result.diagnostics.size() == 2);
  CHECK(talk.session.text() == "plane {}\n");
}

TEST_CASE("session: without a camera or a light they are assumed, and said so") {
  SessionDriver talk;
  talk.say("sphere {}");
  REQUIRE(talk.session.assumptions().size() == 2);
  CHECK(talk.session.assumptions()[0].code == "N0001");
  CHECK(talk.session.scene().lights.size() == 1);
  const rt::lang::Loaded loaded = rt::lang::load_text("sphere {}", "a", ".", {});
  CHECK(talk.session.scene().camera.at == loaded.scene->camera.at);
  talk.say("sun {}");
  CHECK(talk.session.assumptions().size() == 1);
  CHECK(talk.session.scene().lights.size() == 1);
}
