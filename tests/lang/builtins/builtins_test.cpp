#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

namespace {

/// What `str` makes of an expression's value.
std::string text(const std::string& expression, const std::string& before = {}) {
  const Loaded loaded = load(before + "\nsphere { name: str(" + expression + ") }");
  INFO(report(loaded));
  CHECK(loaded.scene);
  return loaded.scene ? loaded.scene->names.at(0) : std::string();
}

} // namespace

TEST_CASE("numbers: operators bind as in mathematics") {
  CHECK(number("2 ^ 3 ^ 2") == 512);
  CHECK(number("-2 ^ 2") == -4);
  CHECK(number("2 ^ -1") == 0.5);
  CHECK(number("1 + 2 * 3 - 4 / 8") == 6.5);
  CHECK(number("7 % 3") == 1);
  CHECK(number("-1 % 3") == 2); // the sign of the divisor
  CHECK(number("1 % -3") == -2);
  CHECK(number("5.5 % 2") == 1.5);
}

TEST_CASE("numbers: trigonometry is in degrees, and exact where it can be") {
  CHECK(number("sin(30)") == 0.5);
  CHECK(number("cos(180)") == -1);
  CHECK(number("cos(90)") == 0);
  CHECK(number("sin(0.5turn)") == 0);
  CHECK(number("tan(45)") == Approx(1).epsilon(1e-15));
  CHECK(number("asin(1)") == 90);
  CHECK(number("acos(-1)") == 180);
  CHECK(number("atan(1)") == 45);
  CHECK(number("atan2(1, -1)") == 135);
  CHECK(number("1rad") == Approx(57.29577951308232).epsilon(1e-15)); // 180/π
}

TEST_CASE("numbers: roundings, bounds and steps") {
  CHECK(text("[floor(-1.5), ceil(-1.5), round(2.5), round(-2.5), trunc(-1.5)]") == "[-2, -1, 3, -3, -1]");
  CHECK(text("abs([-1, 2, -3])") == "[1, 2, 3]");
  CHECK(text("[sign(-3), sign(0), sign(9)]") == "[-1, 0, 1]");
  CHECK(text("[clamp(2), clamp(-1), clamp(5, 0, 3), clamp(x: 1, low: 2, high: 3)]") == "[1, 0, 3, 2]");
  CHECK(number("smoothstep(0, 2, 0.5)") == 0.15625); // t = 1/4: t²(3 − 2t)
  CHECK(number("smoothstep(1, 2, 0)") == 0);
  CHECK(number("hypot(3, 4, 12)") == 13);
  CHECK(number("log(e)") == 1);
  CHECK(number("log2(8) + log10(1000)") == 6);
  CHECK(number("pow(2, 10)") == 1024);
  CHECK(number("tau / pi") == 2);
}

TEST_CASE("vectors: products, lengths, angles") {
  CHECK(number("dot([1, 2, 3], [4, -5, 6])") == 12);
  CHECK(text("cross([1, 0, 0], [0, 1, 0])") == "[0, 0, 1]"); // right-handed
  CHECK(number("length([2, -1, -2])") == 3);
  CHECK(number("length([3, 4])") == 5);
  CHECK(number("distance([1, 2, 3], [1, 5, 7])") == 5);
  CHECK(text("normalize([0, 3, 4])") == "[0, 0.6, 0.8]");
  CHECK(number("angle_between([1, 0, 0], [0, 2, 0])") == 90);
  CHECK(number("angle_between([1, 0, 0], [1, 1e-9, 0])") ==
        Approx(5.729577951308232e-8).epsilon(1e-12)); // acos would give 0
  CHECK(text("project([2, 3, 4], [0, 2, 0])") == "[0, 3, 0]");
  CHECK(text("reflect([1, -1, 0], [0, 5, 0])") == "[1, 1, 0]");
  CHECK(text("[1, 2, 3] * 2 + [0, 0, 1] - [1, 1, 1] / 2") == "[1.5, 3.5, 6.5]");
  CHECK(text("[2, 3, 4] * [1, 2, 3] / [2, 2, 2]") == "[1, 3, 6]");
  CHECK(text("-[1, -2, 3]") == "[-1, 2, -3]");
  CHECK(number("[7, 8, 9].y + [7, 8, 9][-1]") == 17);
}

TEST_CASE("lists: the tools") {
  CHECK(text("map(fn(x) => x * x, 1..4)") == "[1, 4, 9, 16]");
  CHECK(text("filter(fn(x) => x % 2 == 0, 1..6)") == "[2, 4, 6]");
  CHECK(number("fold(fn(a, x) => 10 * a + x, 0, [1, 2, 3])") == 123);
  CHECK(number("sum(1..100)") == 5050);
  CHECK(text("sum([[1, 2, 3], [4, 5, 6]])") == "[5, 7, 9]");
  CHECK(number("product(1..5)") == 120);
  CHECK(number("min(3, 1, 2) + max([3, 1, 2])") == 4);
  CHECK(text("zip([1, 2, 3], [\"a\", \"b\"])") == "[[1, \"a\"], [2, \"b\"]]");
  CHECK(text("concat([1], [], [2, 3])") == "[1, 2, 3]");
  CHECK(text("flatten([[1, 2], 3, [[4]]])") == "[1, 2, 3, [4]]");
  CHECK(text("sort([3, 1, 2])") == "[1, 2, 3]");
  CHECK(text("sort([\"b\", \"a\"])") == "[\"a\", \"b\"]");
  CHECK(text("sort([[1, 9], [2, 3]], key: fn(p) => p[1])") == "[[2, 3], [1, 9]]");
  CHECK(text("reverse(0..3)") == "[3, 2, 1, 0]");
  CHECK(text("[any(fn(x) => x > 2, [1, 2, 3]), all(fn(x) => x > 2, [1, 2, 3]), any([]), all([])]") ==
        "[true, false, false, true]");
  CHECK(text("[contains([1, 2], 2), contains(0..3, 1.5)]") == "[true, false]");
  CHECK(number("len([]) + len(0..<7) + len(\"Öl\")") == 9);
  CHECK(text("[x + y for x in [10, 20] for y in 1..2 if x + y != 21]") == "[11, 12, 22]");
  CHECK(text("[[i, x] for i, x in [\"a\", \"b\"]]") == "[[0, \"a\"], [1, \"b\"]]");
}

TEST_CASE("ranges: as many elements as the formula says, in spite of rounding") {
  CHECK(number("len(0..1 by 0.1)") == 11);
  CHECK(number("len(0..<1 by 0.1)") == 10);
  CHECK(number("len(0..<360 by 30)") == 12);
  CHECK(number("len(0..2.5)") == 3);
  CHECK(number("len(0..<2.5)") == 3); // the end is none of its elements
  CHECK(number("len(5..1)") == 0);
  CHECK(number("len(5..1 by -2)") == 3);
  CHECK(number("len(3..3)") == 1);
  CHECK(number("len(3..<3)") == 0);
  CHECK(number("(1..9 by 2)[-1]") == 9);
  CHECK(text("[x for x in 1..0 by -0.25]") == "[1, 0.75, 0.5, 0.25, 0]");
  CHECK(number("len(range(5)) + len(range(2, 5)) + len(range(0, 1, 0.25))") == 12);
}

TEST_CASE("builtins: a function written like a method is reported where it stands here") {
  const Loaded loaded = load("a = [1, 2, 3].map(fn(x) => x)\nb = \"abc\".len\nsphere {}");
  REQUIRE(errors(loaded) == std::vector<std::string>{"E0212", "E0212"});
  CHECK(loaded.diagnostics[0].label == "a function comes first: `map(…)`");
  CHECK(loaded.diagnostics[1].label == "`len(…)` counts the elements");
}

TEST_CASE("colours: what another language writes with 255 is a mistake, not a very bright light") {
  const Loaded loaded =
      load("sphere { material: rgb(255, 128, 0) }\nlight { color: rgb(1.5, 1, 1) }\nlight { color: rgb(0, -1, 0) }");
  CHECK(errors(loaded) == std::vector<std::string>{"E0310", "E0310", "E0310"});
  CHECK(loaded.diagnostics[0].label == "write `255 / 255`, or the whole colour as `#rrggbb`");
  CHECK(loaded.diagnostics[1].label == "light that is brighter than white is `linear_rgb(r, g, b)`");
  CHECK(loaded.diagnostics[2].label == "this is -1");
  CHECK(errors("light { color: linear_rgb(255, 2, 0) }").empty());
}

TEST_CASE("colours: sRGB in, linear light inside") {
  // IEC 61966-2-1: ((0.5 + 0.055) / 1.055)^2.4 = 0.21404114048223255
  CHECK(number("rgb(0.5, 0, 1).r") == Approx(0.21404114048223255).epsilon(1e-14));
  CHECK(number("linear_rgb(0.5, 0, 1).r") == 0.5);
  CHECK(number("#ff8000.b") == 0);
  CHECK(text("#8fd3a0") == "#8fd3a0");
  CHECK(text("#f80 == #ff8800") == "true");
  CHECK(text("hsv(0, 1, 1)") == "#ff0000");
  CHECK(text("hsv(120, 1, 1)") == "#00ff00");
  CHECK(text("hsv(-120, 1, 1)") == "#0000ff");
  CHECK(text("hsv(60, 0.5, 1) == rgb(1, 1, 0.5)") == "true");
  CHECK(number("mix(black, white, 0.25).g") == 0.25);
  CHECK(number("(white * 0.5 + 0.25).r") == 0.75);
  CHECK(text("mix(1, 3, 0.5)") == "2");
  CHECK(text("mix([0, 0, 0], [2, 4, 6], 0.5)") == "[1, 2, 3]");
  CHECK(text("rebeccapurple") == "#663399");
}

TEST_CASE("strings: joined, compared, and numbers as text that reads back") {
  CHECK(text("\"a\" + \"b\"") == "ab");
  CHECK(text("0.1 + 0.2") == "0.30000000000000004");
  CHECK(text("[1, -0.5, 1e21, 2 - 2, -(1 - 1)]") == "[1, -0.5, 1e+21, 0, 0]");
  CHECK(text("{ width: 2, name: \"a\\\"b\" }") == "{ width: 2, name: \"a\\\"b\" }");
  CHECK(text("[true, none, 0..<5, 1..3 by 0.5]") == "[true, none, 0..<5, 1..3 by 0.5]");
  CHECK(text("sphere { radius: 2, at: [1, 2, 3] }") == "sphere { radius: 2, at: [1, 2, 3] }");
  CHECK(text("[\"a\" < \"b\", \"b\" <= \"a\"]") == "[true, false]");
}

TEST_CASE("equality: by content") {
  CHECK(text("[1, 2, 3] == [1, 2, 3] and [1, 2] != [1, 2, 3]") == "true");
  CHECK(text("[0, 1, 2] == 0..2") == "true");
  CHECK(text("{ a: 1, b: 2 } == { b: 2, a: 1 }") == "true");
  CHECK(text("1 == \"1\"") == "false");
  CHECK(text("sphere { radius: 2 } == sphere { radius: 2 }") == "true");
  CHECK(text("sphere { radius: 2 } == sphere { radius: 3 }") == "false");
  CHECK(text("sphere {}.move(x: 1) == sphere {}") == "false");
}

TEST_CASE("random: a hash of its keys, the same on every machine") {
  CHECK(text("random(1) == random(1.0) and random(0) == random(-0)") == "true");
  CHECK(text("random(1) != random(2) and random(1, 2) != random(2, 1) and random(\"a\") != random(\"b\")") == "true");
  // The mean of n uniform numbers has the deviation 1/√(12 n): 0.0029 for n = 10,000.
  CHECK(number("sum([random(i) for i in 0..<10000]) / 10000") == Approx(0.5).margin(0.01));
  CHECK(number("sum([random(i, \"y\") for i in 0..<10000]) / 10000") == Approx(0.5).margin(0.01));
  // Neighbouring keys are independent: the mean of the products is 1/4.
  CHECK(number("sum([random(i) * random(i + 1) for i in 0..<10000]) / 10000") == Approx(0.25).margin(0.01));
  CHECK(number("min([random(i) for i in 0..<10000])") >= 0);
  CHECK(number("max([random(i) for i in 0..<10000])") < 1);
  // What pictures depend on must not change from version to version. (Computed by another program from the
  // description.)
  CHECK(number("random(0)") == 0.1687122340570506);
  CHECK(number("random(1, 2, \"three\")") == 0.38861411119071343);
}

TEST_CASE("noise: 0 at whole coordinates, smooth, between -1 and 1") {
  CHECK(number("noise_at([3, -2, 7])") == 0);
  CHECK(number("abs(noise_at([0.3, 0.4, 0.5]) - noise_at([0.3, 0.4, 0.500001]))") < 1e-5);
  CHECK(number("max([abs(noise_at([i * 0.173, i * 0.31, i * 0.77])) for i in 0..<5000])") <= 1);
  CHECK(number("max([abs(noise_at([i * 0.173, i * 0.31, i * 0.77])) for i in 0..<5000])") > 0.5);
  CHECK(number("sum([noise_at([i * 0.173, i * 0.31, i * 0.77]) for i in 0..<5000]) / 5000") == Approx(0).margin(0.02));
  CHECK(text("noise_at([0.5, 0.5, 0.5], 1) != noise_at([0.5, 0.5, 0.5], 2)") == "true");
  // Computed by another program from the description: hashed gradients, blended by 6t⁵ − 15t⁴ + 10t³.
  CHECK(number("noise_at([0.3, 1.7, 2.2])") == Approx(0.37615322169528315).epsilon(1e-12));
}

TEST_CASE("numbers: with a point at either end, and with a sign") {
  CHECK(number(".5 + 5.") == 5.5);
  CHECK(number("+60") == 60);
  CHECK(number("5.e2 + .25e1") == 502.5);
  CHECK(number("2 - +1") == 1);
  CHECK(number("-+-3") == 3);
  CHECK(number("+2 ^ 2") == 4);
  CHECK(number("2 ^ +2") == 4);
  CHECK(number("(+[1, 2, 3]).y") == 2);
  CHECK(number(".25turn") == 90);
  CHECK(text("[x for x in .5..2.]") == "[0.5, 1.5]");
  CHECK(text("[x for x in 1. .. 3]") == "[1, 2, 3]");
  CHECK(text("[x for x in 1..3.]") == "[1, 2, 3]");
  CHECK(text("[.5\n5.\n+6]") == "[0.5, 5, 6]");
  CHECK(errors("sphere { radius: +\"a\" }") == std::vector<std::string>{"E0304"});
  CHECK(errors("x = 5.x\nsphere {}") == std::vector<std::string>{"E0212"});
}

TEST_CASE("numbers: the set square is exact both ways") {
  CHECK(number("tan(45)") == 1);
  CHECK(number("tan(135)") == -1);
  CHECK(text("sin(45) == cos(45)") == "true");
  CHECK(text("sin(60) == cos(30)") == "true");
  CHECK(number("asin(sqrt(0.5))") == 45);
  CHECK(number("acos(-sqrt(0.5))") == 135);
  CHECK(number("asin(0.5)") == 30);
  CHECK(number("acos(0.5)") == 60);
  CHECK(number("atan(-1)") == -45);
  CHECK(number("angle_between([1, 0, 0], [1, 1, 0])") == 45);
}
