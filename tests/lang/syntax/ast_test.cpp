#include "tests/support/parsing.hpp"

#include <catch2/catch.hpp>

using namespace rt::lang;
using rt::tests::parse_text;

namespace {

bool say_the_same(const char* left, const char* right) {
  const auto a = parse_text(left), b = parse_text(right);
  CHECK(equal(a.ast(), a.symbols, a.ast(), a.symbols));
  return equal(a.ast(), a.symbols, b.ast(), b.symbols);
}

} // namespace

TEST_CASE("ast: trees are equal whatever the layout") {
  CHECK(
      say_the_same("sphere { radius: 2, at: [1, 2, 3] }", "// a ball\nsphere {\n  radius: 2.0;\n  at: [1\n2\n3]\n}\n"));
  CHECK(say_the_same("x = a + b * c", "x = a +\n (b * c)"));
  CHECK(say_the_same("fn f(x) = x\ny = fn (x) => [z for z in x]", "fn f( x )=x; y=fn(x)=>[ z for z in x ]"));
}

TEST_CASE("ast: trees differ in names, numbers, operators, order and parts") {
  CHECK_FALSE(say_the_same("x = a", "x = b"));
  CHECK_FALSE(say_the_same("x = 1", "x = 2"));
  CHECK_FALSE(say_the_same("x = [1, 2]", "x = [1, 3]"));
  CHECK_FALSE(say_the_same("x = a + b", "x = a - b"));
  CHECK_FALSE(say_the_same("s { a: 1, b: 2 }", "s { b: 2, a: 1 }"));
  CHECK_FALSE(say_the_same("x = 0..1", "x = 0..<1"));
  CHECK_FALSE(say_the_same("x = 0..1", "x = 0..1 by 2"));
  CHECK_FALSE(say_the_same("x = \"a\"", "x = \"b\""));
  CHECK_FALSE(say_the_same("fn f(a) = a", "fn f(a = 1) = a"));
  CHECK_FALSE(say_the_same("if a { b: 1 }", "if a { b: 1 } else {}"));
}

TEST_CASE("ast: is printed as indented text with places") {
  const auto text = parse_text("r = 2\nsphere { at: [1, -2, 3], radius: r ^ 2 }\n");
  CHECK(dump(text.ast(), text.sources, text.symbols) == "1:1 block\n"
                                                        "  1:1 bind\n"
                                                        "    1:1 name r\n"
                                                        "    1:5 number 2\n"
                                                        "  2:1 override\n"
                                                        "    2:1 name sphere\n"
                                                        "    2:8 block\n"
                                                        "      2:10 property at\n"
                                                        "        2:14 numbers [1, -2, 3]\n"
                                                        "      2:26 property radius\n"
                                                        "        2:34 binary ^\n"
                                                        "          2:34 name r\n"
                                                        "          2:38 number 2\n");
}

TEST_CASE("symbols: equal names have equal numbers, in the order of first meeting") {
  SymbolTable symbols;
  CHECK(symbols.intern("a") == Symbol{0});
  CHECK(symbols.intern("b") == Symbol{1});
  CHECK(symbols.intern("a") == Symbol{0});
  CHECK(symbols.find("b") == Symbol{1});
  CHECK(symbols.find("c") == no_symbol);
  for (int i = 0; i < 10'000; ++i) symbols.intern("name" + std::to_string(i));
  for (int i = 0; i < 10'000; ++i) {
    const std::string name = "name" + std::to_string(i);
    REQUIRE(symbols.name(symbols.find(name)) == name);
    REQUIRE(static_cast<std::uint32_t>(symbols.find(name)) == static_cast<std::uint32_t>(i) + 2);
  }
}
