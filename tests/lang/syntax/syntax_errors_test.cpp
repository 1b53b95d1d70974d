#include "tests/support/parsing.hpp"

#include <catch2/catch.hpp>

#include <random>

using namespace rt::lang;
using rt::tests::parse_text;
using rt::tests::shape;

namespace {

using Codes = std::vector<std::string>;

std::string repeated(std::string_view what, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += what;
  return out;
}

} // namespace

TEST_CASE("syntax errors: every mistake of a file is reported, and what is right is kept") {
  const auto text = parse_text("sphere { radius 1, at: [0, 1, 0] }\n"
                               "x = = 2\n"
                               "box { size: 1 }\n"
                               "group {\n"
                               "  sphere { radius: }\n"
                               "  cone { radius: 2 }\n"
                               "}\n"
                               "y = 3 +* 4\n"
                               "plane {}\n");
  CHECK(text.codes() == Codes{"E0102", "E0101", "E0101", "E0101"});
  CHECK(shape(text) == "sphere{ERROR; at: [0 1 0]}; ERROR:x; box{size: 1}; group{sphere{ERROR}; cone{radius: 2}}; "
                       "ERROR:y; plane{}");
}

TEST_CASE("syntax errors: a broken declaration still declares its name") {
  CHECK(shape(parse_text("x = [1 2]\ny = x")) == "ERROR:x; (= y x)");
  CHECK(shape(parse_text("def table(width) box {}")) == "ERROR:table");
  CHECK(shape(parse_text("fn f(x) x")) == "ERROR:f");
  CHECK(shape(parse_text("param p 3")) == "ERROR:p");
  CHECK(shape(parse_text("use \"a\" as p q")) == "ERROR:p");
  CHECK(shape(parse_text("1 2")) == "ERROR");
}

TEST_CASE("syntax errors: a forgotten bracket costs one report and nothing behind it") {
  const auto list = parse_text("sphere {\n  at: [1, 2, 3\n  radius: 2\n}\nbox {}\n");
  CHECK(list.codes() == Codes{"E0103"});
  CHECK(shape(list) == "sphere{at: [1 2 3]; radius: 2}; box{}");
  const auto parenthesis = parse_text("r = max(1, 2\nsphere { radius: r }\n");
  CHECK(parenthesis.codes() == Codes{"E0103"});
  CHECK(shape(parenthesis) == "(= r (call max 1 2)); sphere{radius: r}");
  const auto before_brace = parse_text("sphere { radius: (1 + 2 }\nbox {}\n");
  CHECK(before_brace.codes() == Codes{"E0103"});
  CHECK(shape(before_brace) == "sphere{radius: (+ 1 2)}; box{}");
  const auto brace = parse_text("group {\n  sphere {\n    radius: 1\n  box {}\n}\nplane {}\n");
  CHECK(brace.codes() == Codes{"E0103"});
  CHECK(brace.parsed.diagnostics[0].span == Span{0, 17, 18});
}

TEST_CASE("syntax errors: what is clear enough is read as it was meant") {
  CHECK(shape(parse_text("x = a && b || !c")) == "(= x (or (and a b) c))");
  CHECK(shape(parse_text("x = 2 ** 3")) == "(= x (^ 2 3))");
  CHECK(shape(parse_text("x = 'a'")) == "(= x \"a\")");
  CHECK(shape(parse_text("x = [2cm, 3_000]")) == "(= x [2 3])");
  CHECK(shape(parse_text("x = 1...3")) == "(= x (.. 1 3 _))");
  CHECK(shape(parse_text("let x = 1")) == "(= x 1)");
  CHECK(shape(parse_text("function f(x) = x")) == "(fn f (x) x)");
  CHECK(shape(parse_text("sphere\n{ radius: 2 }")) == "sphere{radius: 2}");
  CHECK(shape(parse_text("if a { b: 1 }\nelse { b: 2 }")) == "(if a {b: 1} {b: 2})");
  CHECK(shape(parse_text("x = f(a = 1)")) == "(= x (call f a: 1))");
  CHECK(shape(parse_text("if x = 1 { y: 2 }")) == "(if (== x 1) {y: 2} _)");
}

TEST_CASE("syntax errors: depth is bounded, whatever nests") {
  for (const char* unit : {"(", "[", "{", "f(", "f[", "f{", "a: {", "fn (x) => ", "if ", "[fn (x) => (", "f(a: "}) {
    INFO(unit);
    const auto text = parse_text(repeated(unit, 100'000));
    REQUIRE(text.codes().size() == 1);
    CHECK(text.codes()[0] == "E0125");
  }
  for (const char* unit : {"-", "not ", "1 + ", "a | ", "2 ^ ", "if a { 1 } else "}) {
    INFO(unit);
    const auto text = parse_text("x = " + repeated(unit, 100'000) + "y");
    REQUIRE(text.codes().size() >= 1);
    CHECK(text.codes()[0] == (std::string(unit) == "if a { 1 } else " ? "E0126" : "E0125"));
  }
  for (const char* suffix : {".b", "()", "[1]", "{}"}) {
    INFO(suffix);
    CHECK(parse_text("x = f" + repeated(suffix, 100'000)).codes() == Codes{"E0125"});
  }
  CHECK(parse_text("x = " + repeated("if a { 1 } else ", 100'000) + "{ 2 }").codes() == Codes{"E0125"});
  CHECK(parse_text("x = " + repeated("[", 100) + repeated("]", 100)).codes().empty());
  CHECK(parse_text("x = 0" + repeated(" + 1", 1'000)).codes().empty());
}

TEST_CASE("syntax errors: a file that is no scene is not reported byte by byte") {
  std::mt19937 random(1);
  std::string noise;
  for (int i = 0; i < 100'000; ++i) noise += static_cast<char>(random() % 95 + 32);
  const auto text = parse_text(repeated(") ", 1'000) + noise);
  CHECK(text.codes().size() <= 100);
  CHECK(parse_text("\xff\xfe\x00").codes() == Codes{"E0124"});
}

TEST_CASE("syntax errors: reports come in the order of the text") {
  const auto text = parse_text("group {\n  x = 0x5\n  y = (1\n  z = 2cm\n}\n'a'\n");
  const auto& found = text.parsed.diagnostics;
  REQUIRE(found.size() == 4);
  for (std::size_t i = 1; i < found.size(); ++i) CHECK(found[i - 1].span.begin < found[i].span.begin);
}

TEST_CASE("syntax errors: the end of the file is shown where its text ends") {
  const auto text = parse_text("x = 1 +\n\n\n");
  REQUIRE(text.codes() == Codes{"E0101"});
  CHECK(text.sources.position(0, text.parsed.diagnostics[0].span.begin).line == 1);
}
