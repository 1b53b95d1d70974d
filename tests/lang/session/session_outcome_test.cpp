#include "tests/support/session_driver.hpp"

using namespace rt::tests;

TEST_CASE("session: each accepted input says what came of it") {
  SessionDriver talk;
  const auto says = [&](const std::string& text) {
    std::string all;
    for (const std::string& change : talk.say(text).changes) all += (all.empty() ? "" : "; ") + change;
    return all;
  };
  CHECK(says("sphere {}") == "placed sphere");
  CHECK(says("ball = sphere { radius: 2 }") == "ball is a sphere");
  CHECK(says("ball") == "placed ball");
  CHECK(says("ball = box {}") == "ball is now a box; rebuilt: ball");
  CHECK(says("for i in 0..4 { sphere { at: [i, 0, 0] } }") == "placed 5 × sphere");
  CHECK(says("for i in 0..1 { box {}, light { at: [0, i, 0] } }") == "placed 2 × box, 2 × light");
  CHECK(says("def table(width = 2) { box { size: width } }") == "table is a noun");
  CHECK(says("table { width: 3 }") == "placed table");
  CHECK(says("fn double(x) = 2 * x") == "double is a function");
  CHECK(says("fn double(x) = x + x") == "double is now a function");
  CHECK(says("r = 1.5\nmany = 0..99\nm = material { color: red }") == "r is 1.5; many is 0..99; m is a material");
  CHECK(says("names = [\"a long name\", \"another long name\", \"a third one\"]") == "names is a list");
  CHECK(says("background: red") == "background is set");
  CHECK(says("background: blue") == "background is now set");
  CHECK(says("camera { at: [0, 1, 9] }") == "placed camera");
  CHECK(says("param height = 2") == "height is 2");
  CHECK(says("if 1 > 2 { sphere {} }") == "placed nothing");
  CHECK(says("1 + 1") == "");
  CHECK(says("// a note") == "");
}
