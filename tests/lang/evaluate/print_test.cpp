#include "tests/support/loading.hpp"
#include "tests/support/session_driver.hpp"

#include <catch2/catch.hpp>

using namespace rt::lang;
using namespace rt::tests;

namespace {

/// The lines that a scene prints, each with its place.
std::vector<std::string> printed(const std::string& text) {
  const Loaded loaded = load(text);
  INFO(report(loaded));
  CHECK(loaded.scene);
  std::vector<std::string> lines;
  for (const Diagnostic& line : loaded.printed) lines.push_back(render_line(line, loaded.sources));
  return lines;
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("print: values and the place, in the order of evaluation") {
  CHECK(printed("r = 2\nprint(\"r is\", r)\n  print([1, 2, 3], true)\nprint(red)\nsphere {}") ==
        Lines{"test.rtl:2:1: r is 2\n", "test.rtl:3:3: [1, 2, 3] true\n", "test.rtl:4:1: #ff0000\n"});
}

TEST_CASE("print: in loops, functions, branches and blocks of things, once for each evaluation") {
  CHECK(printed("for i in 1..3 { print(i) }") ==
        Lines{"test.rtl:1:17: 1\n", "test.rtl:1:17: 2\n", "test.rtl:1:17: 3\n"});
  CHECK(printed("fn f(x) {\n  print(\"f\", x)\n  y = x * x\n  print(y)\n  y\n}\nsphere { radius: f(2) + f(3) }") ==
        Lines{"test.rtl:2:3: f 2\n", "test.rtl:4:3: 4\n", "test.rtl:2:3: f 3\n", "test.rtl:4:3: 9\n"});
  CHECK(printed("x = if true {\n print(1)\n 2 } else {\n print(3)\n 4 }\nsphere { print(x) }") ==
        Lines{"test.rtl:2:2: 1\n", "test.rtl:6:10: 2\n"});
  CHECK(printed("def pair(n) { print(n), sphere { radius: n } }\npair { n: 1 }\npair { n: 2 }") ==
        Lines{"test.rtl:1:15: 1\n", "test.rtl:1:15: 2\n"});
}

TEST_CASE("print: lines of one wording are each printed at their own place") {
  std::string text;
  for (int i = 0; i < 20; ++i) text += "print(" + std::to_string(i) + ".5)\n";
  const Lines lines = printed(text + "sphere {}");
  REQUIRE(lines.size() == 20);
  for (std::size_t i = 0; i < 20; ++i)
    CHECK(lines[i] == "test.rtl:" + std::to_string(i + 1) + ":1: " + std::to_string(i) + ".5\n");
}

TEST_CASE("print: what is never called, and a branch that is not taken, prints nothing") {
  CHECK(printed("fn f(x) {\n print(x)\n x }\nif false { print(1) }\nsphere {}").empty());
}

TEST_CASE("print: it is no value") {
  CHECK(errors("sphere { radius: print(1) }") == std::vector<std::string>{"E0301"});
  CHECK(errors("fn f(x) { x, x }\nsphere { radius: f(1) }") == std::vector<std::string>{"E0314"});
}

TEST_CASE("print: a session hears it once, and keeps it out of the document") {
  SessionDriver s;
  const SessionResult first = s.say("print(1 + 1)");
  REQUIRE(first.printed.size() == 1);
  CHECK(first.printed[0].message == "2");
  CHECK(first.values.empty());
  CHECK(s.session.text().empty());
  s.say("fn f(x) {\n print(x)\n x }");
  CHECK(s.say("sphere { radius: f(3) }").printed.size() == 1);
  CHECK(s.say("box {}").printed.empty());
}
