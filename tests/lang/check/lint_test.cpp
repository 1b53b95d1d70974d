// The rules of the lint that the text alone shows. Each has a scene that breaks it and ones that nearly do.

#include "lang/check/lint/rules.hpp"
#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace rt;
using namespace rt::lang;

namespace {

Loaded linted(std::string text, std::vector<std::pair<std::string, std::string>> defines = {}) {
  LoadOptions options;
  options.lint = true;
  options.defines = std::move(defines);
  return tests::load(std::move(text), options);
}

/// "W0101 at 2:1, W0104 at 3:10"
std::string remarks(const std::string& text) {
  const Loaded loaded = linted(text);
  CHECK(tests::errors(loaded).empty());
  std::string out;
  for (const Diagnostic& d : without_allowed(loaded.remarks, loaded.sources, {})) {
    const Position at = loaded.sources.position(d.span.file, d.span.begin);
    CHECK(d.severity == Severity::warning);
    CHECK_FALSE(d.message.empty());
    out += fmt::format("{}{} at {}:{}", out.empty() ? "" : ", ", d.code, at.line, at.column);
  }
  return out;
}

std::string message(const std::string& text) {
  const Loaded loaded = linted(text);
  REQUIRE(loaded.remarks.size() == 1);
  const Diagnostic& d = loaded.remarks.front();
  return d.message + " | " + d.label;
}

} // namespace

TEST_CASE("lint: a thing that is bound must be placed") {
  CHECK(remarks("ball = sphere {}\nbox {}") == "W0101 at 1:1");
  CHECK(message("ball = sphere {}\nbox {}") == "`ball` is bound and never placed | it is not in the scene");
  CHECK(remarks("ball = sphere {}\nball") == "");
  CHECK(remarks("ball = sphere {}\nball { at: [3, 0, 0] }") == "");
  CHECK(remarks("ball = sphere {}\nbox {} - ball") == "");
  CHECK(remarks("ball = sphere {}\nfor i in 0..2 { ball.move(x: i) }") == "");
  CHECK(remarks("lamp = light { at: [0, 4, 0] }\nbox {}") == "W0101 at 1:1");
  CHECK(remarks("die = box {} & sphere { radius: 0.7 }\nplane {}") == "W0101 at 1:1");
}

TEST_CASE("lint: what leads only to a thing that is not placed is reported once, at the end that is missing") {
  CHECK(remarks("r = 2\nball = sphere { radius: r }\nbig = ball { scale: 2 }\nbox {}") == "W0101 at 3:1");
}

TEST_CASE("lint: a thing of which only properties are read is not placed") {
  CHECK(message("ball = sphere { radius: 2 }\nbox { size: ball.radius }") ==
        "`ball` is bound and never placed | only its properties are read");
  CHECK(remarks("ball = sphere { radius: 2 }\nbox { size: ball.radius }\nball") == "");
  CHECK(remarks("ball = sphere { radius: 2 }\nbox {}\nexpect ball.radius == 2") == "");
}

TEST_CASE("lint: names, functions, defs and params must be used") {
  CHECK(remarks("r = 2\nbox {}") == "W0102 at 1:1");
  CHECK(remarks("fn twice(x) = 2 * x\nbox {}") == "W0102 at 1:4");
  CHECK(remarks("def leg() { box {} }\nbox {}") == "W0102 at 1:5");
  CHECK(remarks("param n = 3\nbox {}") == "W0102 at 1:7");
  CHECK(remarks("param n = 3\nbox { size: n }") == "");
  CHECK(remarks("oak = material { color: peru }\nbox {}") == "W0102 at 1:1");
  CHECK(remarks("box {\n  inner = 2\n  size: 1\n}") == "W0102 at 2:3");
}

TEST_CASE("lint: a function that only calls itself is not used, nor are two that call each other") {
  CHECK(remarks("fn f(n) = if n < 1 { 1 } else { n * f(n - 1) }\nbox {}") == "W0102 at 1:4");
  CHECK(remarks("fn f(n) = if n < 1 { 1 } else { g(n - 1) }\nfn g(n) = f(n)\nbox {}") == "W0102 at 1:4");
  CHECK(remarks("fn f(n) = if n < 1 { 1 } else { g(n - 1) }\nfn g(n) = f(n)\nbox { size: f(2) }") == "");
}

TEST_CASE("lint: a file that places nothing is for others to use") {
  CHECK(remarks("r = 2\ndef leg(h) { box { size: h } }") == "");
  CHECK(remarks("r = 2\ndef leg(h) { box {} }") == "W0103 at 2:9");
}

TEST_CASE("lint: parameters must be used, those of a def and of a fn") {
  CHECK(remarks("def leg(h, w = 1) { box { size: h } }\nleg { h: 2 }") == "W0103 at 1:12");
  CHECK(remarks("fn f(a, b) = a\nbox { size: f(1, 2) }") == "W0103 at 1:9");
  CHECK(remarks("fn f(a, _b) = a\nbox { size: f(1, 2) }") == "");
  CHECK(remarks("box { size: fold(fn(a, b) => a, 1, [1, 2]) }") == ""); // there for its place
  CHECK(remarks("for i, x in [1, 2] { box { at: [x, 0, 0] } }") == "");
}

TEST_CASE("lint: pi in an angle is radians, unless it is divided out") {
  CHECK(remarks("box { rotate: [0, pi / 4, 0] }") == "W0104 at 1:19");
  CHECK(remarks("box {}.rotate(y: 2 * pi)") == "W0104 at 1:18");
  CHECK(remarks("box {}.rotate(axis: [pi, 1, 0], angle: 30)") == "");
  CHECK(remarks("box {}.move(y: pi)") == "");
  CHECK(remarks("box { size: 1 + sin(pi / 2) }") == "W0104 at 1:21");
  CHECK(remarks("box { size: 2 + sin(180 * 0.3 / pi) }") == ""); // 0.3 radians in degrees
  CHECK(remarks("box { size: pi }") == "");
  CHECK(remarks("spot { at: [0, 9, 0], angle: pi / 6 }\nbox {}") == "W0104 at 1:30");
}

TEST_CASE("lint: radians are followed through names and loops") {
  CHECK(remarks("turn = tau / 3\nbox { rotate: [0, turn, 0] }") == "W0104 at 2:19");
  CHECK(remarks("for a in 0..<tau by 1 { box { at: [cos(a), 0, 0] } }") == "W0104 at 1:40");
  CHECK(remarks("for a in 0..<360 by 30 { box { at: [pi * cos(a), 0, 0] } }") == "");
}

TEST_CASE("lint: well-known angles in radians, rounded or cut off, are reported with their degrees") {
  CHECK(message("box { rotate: [0, 1.57, 0] }") ==
        "this looks like radians, and angles are in degrees | write `90`, or `1.57rad`");
  CHECK(remarks("box {}.rotate(y: 3.1415)") == "W0104 at 1:18"); // pi = 3.14159…, cut off
  CHECK(remarks("box {}.rotate(y: -0.785398)") == "W0104 at 1:18");
  CHECK(remarks("box {}.rotate(y: 0.52)") == ""); // pi/6 = 0.5236 takes three decimals
  CHECK(remarks("box {}.rotate(y: 3.2)") == "");
  CHECK(remarks("box {}.rotate(y: 1.5708rad)") == "");
  CHECK(remarks("box { at: [1.5708, 0, 0] }") == "");
}

TEST_CASE("lint: a view of a fraction of three degrees was meant in radians") {
  CHECK(remarks("box {}\ncamera { fov: 0.9 }") == "W0104 at 2:15");
  CHECK(remarks("box {}\ncamera { fov: 1 }") == ""); // a telescope's
  CHECK(remarks("box {}\ncamera { fov: 4.5 }") == "");
  CHECK(remarks("box {}\ncamera { fov: 0.9rad }") == "");
}

TEST_CASE("lint: a name that hides a kind of thing") {
  CHECK(remarks("box = 2\nsphere { radius: box }") == "W0105 at 1:1");
  CHECK(remarks("def table() { box {} }\nglass = glass { color: red }\ntable { material: glass }") == "");
}

TEST_CASE("lint: a transparent solid says how it bends light") {
  CHECK(remarks("sphere { material: material { refract: 0.9 } }") == "W0106 at 1:40");
  CHECK(remarks("sphere { material: { refract: 0.9 } }") == "W0106 at 1:31");
  CHECK(remarks("sphere { material: material { refract: 0.9, ior: 1 } }") == "");
  CHECK(remarks("sphere { material: material { refract: 0 } }") == "");
  // Named once, worn twice: the first gives it an index, the second does not.
  CHECK(remarks("m = material { refract: 0.9 }\nsphere { material: m { ior: 1.5 } }") == "");
  CHECK(remarks("m = material { refract: 0.9 }\nsphere { material: m { ior: 1.5 } }\nbox { material: m }") ==
        "W0106 at 1:25");
  // What has no inside bends nothing.
  CHECK(remarks("disc { material: material { refract: 0.9 } }") == "");
  CHECK(remarks("group { sphere {} } { material: material { refract: 0.9 } }") == "W0106 at 1:53");
}

TEST_CASE("lint: comments allow what is meant") {
  CHECK(remarks("ball = sphere {} // lint: allow never_placed\nbox {}") == "");
  CHECK(remarks("ball = sphere {} // lint: allow W0101: for later\nbox {}") == "");
  CHECK(remarks("// lint: allow never_placed\n\nball = sphere {}\nbox {}") == "");
  CHECK(remarks("// lint: allow never_placed\nbox {}\nball = sphere {}") == "W0101 at 3:1");
  CHECK(remarks("box {}\nball = sphere {}\n// lint: allow never_used, never_placed in this file") == "");
  CHECK(remarks("box {}\n/* lint: allow never_placed */ ball = sphere {}") == "");
  CHECK(remarks("box {}\nball = sphere {} // lint: allow radians") == "W0101 at 2:1");
  CHECK(remarks("box { rotate: [0,\n  pi, // lint: allow radians\n  0] }") == "");
  CHECK(remarks("text = \"// lint: allow never_used\"\nbox {}") == "W0102 at 1:1");
}

TEST_CASE("lint: a comment that it does not understand is reported") {
  CHECK(remarks("box {} // lint: allow hiden") == "W0001 at 1:23");
  CHECK(remarks("box {} // lint: allow") == "W0001 at 1:8");
  CHECK(remarks("box {} // lint: silence hidden") == "W0001 at 1:8");
  CHECK(remarks("box {} // about lint: nothing") == "");
}

TEST_CASE("lint: nothing is looked for unless it is wanted, and errors come first") {
  CHECK(tests::load("ball = sphere {}\nbox { rotate: [0, pi, 0] }").remarks.empty());
  CHECK(linted("ball = sphere {}\nbox { raduis: 2 }").remarks.empty());
  CHECK(linted("param n = 3\nsphere { radius: n }", {{"n", "2"}}).remarks.empty());
}

TEST_CASE("lint: each rule has a code of the registry and a name of its own") {
  for (const LintRule& rule : lint_rules()) {
    INFO(rule.name);
    CHECK(find_code(rule.code));
    CHECK(find_lint_rule(rule.name) == &rule);
    CHECK(find_lint_rule(rule.code) == &rule);
  }
  for (const Code& code : all_codes()) {
    INFO(code.code);
    CHECK(code.code.starts_with('W') == (find_lint_rule(code.code) != nullptr));
  }
  CHECK(find_lint_rule("no_such_rule") == nullptr);
}
