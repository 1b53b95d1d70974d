#include "tests/support/loading.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::lang;
using namespace rt::tests;

using Codes = std::vector<std::string>;

TEST_CASE("names: an initialiser sees the outer name, not its own") {
  CHECK(number("f()", "r = 1\nfn f() { r = r + 1\n r * 10 }") == 20);
  CHECK(errors("r = r + 1\nsphere {}") == Codes{"E0203"});
  CHECK(errors("fn f(x = x) = x\nsphere { radius: f(1) }") == Codes{"E0203"});
}

TEST_CASE("names: a library material may be shadowed by a copy of itself") {
  const Loaded loaded = load("glass = glass { color: red }\nsphere { material: glass }");
  REQUIRE(loaded.scene);
  CHECK(loaded.scene->materials.size() == 1);
  CHECK(std::get<Color>(loaded.scene->materials[0].color) == Color{1, 0, 0});
  CHECK(loaded.scene->materials[0].ior == 1.52);
}

TEST_CASE("names: binding one twice names the first line; inner blocks may bind it anew") {
  const Loaded loaded = load("a = 1\n\na = 2\nsphere {}");
  CHECK(errors(loaded) == Codes{"E0202"});
  REQUIRE(find(loaded, "E0202")->notes.size() == 1);
  CHECK(find(loaded, "E0202")->notes[0].message == "first bound here, on line 1");
  CHECK(errors("a = 1\nfor i in 0..1 { a = i + 2\n sphere { radius: a } }\nsphere { radius: a }").empty());
  CHECK(errors("fn a() = 1\ndef a() { sphere {} }\nsphere {}") == Codes{"E0202"});
  CHECK(errors("fn f(x, x) = x\nsphere {}") == Codes{"E0202"});
}

TEST_CASE("names: of a name that is bound before the function of the same name, the function is one too many") {
  const Loaded loaded = load("a = 1\ndef a() { sphere {} }\na {}");
  const Diagnostic* d = find(loaded, "E0202");
  REQUIRE(d);
  CHECK(d->span.begin == 10);
  REQUIRE(d->notes.size() == 1);
  CHECK(d->notes[0].message == "first bound here, on line 1");
}

TEST_CASE("names: functions call each other before they are written") {
  const std::string functions = "fn is_even(n) = if n == 0 { true } else { is_odd(n - 1) }\n"
                                "fn is_odd(n) = if n == 0 { false } else { is_even(n - 1) }";
  CHECK(number("if is_even(10) { 1 } else { 2 }", functions) == 1);
  CHECK(number("factorial(10)", "a = factorial(3)\nfn factorial(n) = if n < 2 { 1 } else { n * factorial(n - 1) }") ==
        3628800);
}

TEST_CASE("names: a function that is called before the names in it have values is a mistake") {
  CHECK(errors("a = f()\nk = 3\nfn f() = k\nsphere { radius: a }") == Codes{"E0203"});
  CHECK(number("f()", "k = 3\nfn f() = k") == 3);
}

TEST_CASE("names: functions keep the names around them") {
  CHECK(number("adders[2](10)", "adders = [fn(x) => x + k for k in 0..3]") == 12);
  CHECK(number("add(1)(2)", "fn add(a) = fn(b) => a + b") == 3);
  CHECK(number("compose(fn(x) => x + 1, fn(x) => x * 10)(4)", "fn compose(f, g) = fn(x) => f(g(x))") == 41);
  CHECK(number("counters[1]()", "counters = [f(i) for i in 0..2]\nfn f(i) { square = i * i\n fn() => square + i }") ==
        2);
}

TEST_CASE("names: in a loop every turn has its own") {
  const Loaded loaded =
      load("fn twice(f, x) = f(f(x))\nfor i in 1..3 { step = fn(x) => x + i\n sphere { at: [twice(step, 0), 0, 0] } }");
  REQUIRE(loaded.scene);
  REQUIRE(loaded.scene->objects.size() == 3);
  CHECK(loaded.scene->objects[0].at.x == 2);
  CHECK(loaded.scene->objects[2].at.x == 6);
}

TEST_CASE("names: arguments by position, by name, and by default") {
  const std::string f = "fn f(a, b = 2, c = a * 10) = 100 * a + 10 * b + c";
  CHECK(number("f(1)", f) == 130);
  CHECK(number("f(1, 5)", f) == 160);
  CHECK(number("f(1, c: 0)", f) == 120);
  CHECK(number("f(c: 1, a: 2)", f) == 221);
}

TEST_CASE("names: an if that is a value, with bindings in its branches") {
  CHECK(number("if 1 < 2 { a = 3\n a * a } else { 0 }") == 9);
  CHECK(number("if false { 1 } else if true { 2 } else { 3 }") == 2);
  CHECK(errors("x = if true { 1 }\nsphere { radius: x }") == Codes{"E0313"});
}

TEST_CASE("names: and and or stop where the answer is known") {
  CHECK(number("if false and [][0] { 1 } else { 2 }") == 2);
  CHECK(number("if true or [][0] { 1 } else { 2 }") == 1);
}

TEST_CASE("names: CSS colours and functions of the same name keep apart") {
  const Loaded loaded = load("sphere { material: tan }\nsphere { radius: tan(45) }\nsphere { material: gold }\nlight { "
                             "color: gold }\nsun { color: mix(silver, tan, 0) }");
  INFO(report(loaded));
  REQUIRE(loaded.scene);
  const scene::Scene& scene = *loaded.scene;
  CHECK(std::get<Color>(scene.materials[0].color).r ==
        Approx(0.6444796819705821).epsilon(1e-12));              // #d2: 210/255 decoded
  CHECK(scene.materials[1].metallic == scene::NumberPaint(1.0)); // gold the metal
  const auto& light = std::get<scene::PointLight>(scene.lights[0].source);
  CHECK(light.color.r == 1); // #ffd700
  CHECK(light.color.b == 0);
  CHECK(std::get<scene::SunLight>(scene.lights[1].source).color.r == Approx(0.5271151257058131).epsilon(1e-12)); // #c0
}

TEST_CASE("names: what an unreadable file may have bound is not complained about") {
  CHECK(errors("include \"missing.rtl\"\nsphere { material: brick }") == Codes{"E0601"});
}

TEST_CASE("names: one mistake, one message") {
  CHECK(errors("a = nowhere\nb = a + 1\nsphere { radius: b }\nfor i in a { sphere { radius: i } }") == Codes{"E0201"});
  CHECK(errors("a = (1\nsphere { radius: a }").size() == 1);
  CHECK(errors("for i in 0..<1000 { sphere { radius: \"a\" } }") == Codes{"E0301"});
  CHECK(errors("cylinder { frm: [0, 0, 0], to: [0, 1, 0] }") == Codes{"E0204"});
}

TEST_CASE("names: where a property takes words, an unknown one is told which") {
  const auto label = [](const std::string& text) {
    const Loaded loaded = load(text);
    const Diagnostic* d = find(loaded, "E0201");
    return d ? d->label : "";
  };
  CHECK(label("tone: filmc\nsphere {}") == "did you mean `filmic`?");
  CHECK(label("tone: reinhard\nsphere {}") == "`clip`, `filmic` can be written here");
  CHECK(label("tone: if 1 > 0 { filmc } else { clip }\nsphere {}") == "did you mean `filmic`?");
  CHECK(label("sphere { material: { highlight: phonk } }") == "did you mean `phong`?");
  CHECK(label("tone: clip\nsphere { radius: filmc }") == "not known here");
}

TEST_CASE("names: a comment that was meant as a division and swallows the end of its block is pointed at") {
  for (const std::string text : {"sphere { radius: 7 // 2 }", "sphere { at: [1, 2, 7 //2] }\nsphere {}"}) {
    const Loaded loaded = load(text);
    CHECK(find(loaded, "E0103"));
    const Diagnostic* d = find(loaded, "N0005");
    REQUIRE(d);
    CHECK(d->message == "`//` begins a comment: the value on line 1 is `7`; `floor(7 / 2)` divides and rounds down");
  }
  CHECK_FALSE(find(load("sphere { radius: 7 // 2 mm }\n}"), "N0005"));
}
