#include "tests/support/session_driver.hpp"

using rt::lang::Session;
using rt::lang::SessionResult;
using namespace rt::tests;

TEST_CASE("session: versions are described on one line that says the same") {
  SessionDriver talk;
  talk.say("ball = sphere {\n  radius: 2\n  at: [\n    1\n    2, 3\n  ]\n}");
  talk.say("for i in 0..1 {\n  box {}\n  sphere {}\n    .move(\n  x: i\n)\n}");
  talk.say("a = 1 +\n  2\nb = [\n  x\n  for x in 0..2\n]");
  const auto& versions = talk.session.versions();
  CHECK(versions[1].description == "ball = sphere { radius: 2, at: [ 1, 2, 3 ] }");
  CHECK(versions[2].description == "for i in 0..1 { box {}, sphere {} .move( x: i ) }");
  CHECK(versions[3].description == "a = 1 + 2; b = [ x for x in 0..2 ]");
}

TEST_CASE("session: undo and redo go over every kind of change, and pictures come back") {
  SessionDriver talk;
  const Folder folder;
  const std::string file = folder.write("other.rtl", "light { at: [3, 5, 4] }\nsphere { radius: 1.5 }\n");
  const std::vector<std::function<void()>> changes{
      [&] { talk.say("r = 1"); },
      [&] { talk.say("ball = sphere { radius: r }"); },
      [&] { talk.say("ball"); },
      [&] { talk.say(".move(x: 1)"); },
      [&] { talk.say("r = 2"); },
      [&] { talk.say("background: red"); },
      [&] { talk.say("background: navy"); },
      [&] { talk.say("camera { at: [0, 2, 9] }"); },
      [&] { talk.say("camera { at: [0, 3, 8] }"); },
      [&] { talk.say("sun {}"); },
      [&] { talk.say("def pair() { sphere {}\n box { at: [2, 0, 0] } }"); },
      [&] { talk.say("for i in 0..2 { pair { at: [0, i, -3] } }"); },
      [&] { CHECK(talk.session.set("ball.material", "gold").is_accepted); },
      [&] { talk.say("fn f(x) = x"); },
      [&] { CHECK(talk.session.remove("f").is_accepted); },
      [&] { CHECK(talk.session.reset().is_accepted); },
      [&] { CHECK(talk.session.load(file).is_accepted); },
  };
  std::vector<std::string> texts{talk.session.text()};
  std::vector<std::vector<rt::Rgb32>> pictures{picture(talk.session.scene())};
  for (const auto& change : changes) {
    change();
    texts.push_back(talk.session.text());
    pictures.push_back(picture(talk.session.scene()));
  }
  REQUIRE(talk.session.version() == changes.size());
  const auto check = [&](std::size_t i) {
    INFO("version " << i);
    CHECK(talk.session.version() == i);
    CHECK(talk.session.text() == texts[i]);
    CHECK(are_equal(picture(talk.session.scene()), pictures[i]));
  };
  for (std::size_t i = changes.size(); i-- > 0;) {
    REQUIRE(talk.session.undo());
    check(i);
  }
  CHECK_FALSE(talk.session.undo());
  for (std::size_t i = 1; i <= changes.size(); ++i) {
    REQUIRE(talk.session.redo());
    check(i);
  }
  CHECK_FALSE(talk.session.redo());
  for (const std::size_t i : {std::size_t{5}, std::size_t{12}, std::size_t{0}, std::size_t{9}}) {
    REQUIRE(talk.session.go_to(i));
    check(i);
  }
  CHECK_FALSE(talk.session.go_to(99));
  // Nothing is evaluated for any of that.
  const auto evaluated = talk.session.counters().statements_evaluated;
  talk.session.undo();
  talk.session.redo();
  CHECK(talk.session.counters().statements_evaluated == evaluated);
}

TEST_CASE("session: a change after an undo goes on from there, and what was undone can still be had") {
  SessionDriver talk;
  talk.say("sphere {}");
  talk.say("box {}");
  talk.session.undo();
  talk.say("plane {}");
  CHECK(talk.session.text() == "sphere {}\nplane {}\n");
  CHECK(talk.session.versions()[3].parent == 1);
  CHECK_FALSE(talk.session.redo());
  REQUIRE(talk.session.go_to(2));
  CHECK(talk.session.text() == "sphere {}\nbox {}\n");
  CHECK(talk.session.diff(2, 3) == "- box {}\n+ plane {}\n");
  CHECK(talk.session.diff(2, 2).empty());
}

TEST_CASE("session: after undoing a definition, what it was before is used") {
  SessionDriver talk;
  talk.say("fn f(x) = x");
  talk.say("n = f(1)");
  talk.say("fn f(x) = x + 1");
  CHECK(talk.value("[n, f(5), 0]") == "[2, 6, 0]");
  talk.session.undo();
  CHECK(talk.value("[n, f(5), 0]") == "[1, 5, 0]");
  talk.say("m = f(n)");
  CHECK(talk.value("m") == "1");
}
