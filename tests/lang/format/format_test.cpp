#include "lang/format/format.hpp"
#include "lang/text/tokens.hpp"
#include "tests/paths.hpp"
#include "tests/support/parsing.hpp"
#include "tests/support/random_program.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace rt::lang;
using rt::tests::parse_text;
using rt::tests::RandomProgram;

namespace {

std::string formatted(std::string text) {
  SourceMap sources;
  const FileId file = sources.add("test.rtl", "", std::move(text));
  const Formatted out = format(sources, file);
  for (const Diagnostic& diagnostic : out.diagnostics) FAIL_CHECK(render(diagnostic, sources, false));
  return out.text;
}

std::vector<std::string> comments(std::string_view text) {
  std::vector<std::string> out;
  for (Token token = next_token(text, 0); token.kind != TokenKind::end; token = next_token(text, token.end)) {
    if (token.kind == TokenKind::line_comment || token.kind == TokenKind::block_comment)
      out.emplace_back(text_of(text, token));
  }
  return out;
}

/// A list of consecutive numbers.
std::string numbers(int first, int count) {
  std::string out = "[";
  for (int i = 0; i < count; ++i) out += (i > 0 ? ", " : "") + std::to_string(first + i);
  return out + "]";
}

/// What must hold for every text.
void check_promises(const std::string& text) {
  const std::string once = formatted(text);
  INFO(once);
  const auto before = parse_text(text), after = parse_text(once);
  REQUIRE(after.codes().empty());
  REQUIRE(equal(before.ast(), before.symbols, after.ast(), after.symbols));
  REQUIRE(formatted(once) == once);
  REQUIRE(comments(once) == comments(text));
  REQUIRE(once.find(" \n") == std::string::npos);
  REQUIRE(once.find("\n\n\n") == std::string::npos);
  REQUIRE((once.empty() || (once.front() != '\n' && once.back() == '\n')));
}

} // namespace

TEST_CASE("format: spaces follow one rule") {
  CHECK(formatted("sphere{radius:2,at:[ 1,2 ,3 ]}") == "sphere { radius: 2, at: [1, 2, 3] }\n");
  CHECK(formatted("x=a+b*-c^ - 2") == "x = a + b * -c ^ -2\n");
  CHECK(formatted("x = a-b - -c") == "x = a - b - -c\n");
  CHECK(formatted("for i , x in 0 ..< 9 by 3{ box {} }") == "for i, x in 0..<9 by 3 { box {} }\n");
  CHECK(formatted("f = fn(x , y=2)=>x.y") == "f = fn (x, y = 2) => x.y\n");
  CHECK(formatted("x = f (1) [2].y") == "x = f(1)[2].y\n");
  CHECK(formatted("x = not(a)and(b)") == "x = not (a) and (b)\n");
  CHECK(formatted("x = if(a){1}else{2}") == "x = if (a) { 1 } else { 2 }\n");
  CHECK(formatted("expect a~b\nexpect a~-1") == "expect a ~ b\nexpect a ~ -1\n");
  CHECK(formatted("x={ };y=[ ];z=f( )") == "x = {}\ny = []\nz = f()\n");
  CHECK(formatted("x = {a:1;b:[{c:2}]}") == "x = { a: 1, b: [{ c: 2 }] }\n");
}

TEST_CASE("format: blocks of several lines have one item a line") {
  CHECK(formatted("sphere { radius: 2, at: [1, 2, 3],\nname: \"a\" }") ==
        "sphere {\n  radius: 2\n  at: [1, 2, 3]\n  name: \"a\"\n}\n");
  CHECK(formatted("group { sphere {\nradius: 2 } }") == "group {\n  sphere {\n    radius: 2\n  }\n}\n");
}

TEST_CASE("format: what is wider than 100 columns is broken, blocks before lists") {
  const std::string wide = "glass = material { color: #123456, ambient: 0.1, diffuse: 0.8, specular: 0.3, shininess: "
                           "32, ior: 1.5, reflect: 1 }";
  CHECK(formatted(wide) == "glass = material {\n  color: #123456\n  ambient: 0.1\n  diffuse: 0.8\n  specular: 0.3\n"
                           "  shininess: 32\n  ior: 1.5\n  reflect: 1\n}\n");
  std::string list = "points = [";
  for (int i = 0; i < 30; ++i) list += std::to_string(1000 + i) + (i < 29 ? ", " : "]");
  const std::string out = formatted(list);
  std::istringstream lines(out);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) CHECK(line.size() <= 100);
  CHECK(count == 4);
  CHECK(formatted("xs = [sphere { radius: 0.11, at: [0.27 * p[0], 0.55, 0.27 * p[1]], material: ink }.rotate(turn) for "
                  "p in pips(n)]") == "xs = [\n  sphere { radius: 0.11, at: [0.27 * p[0], 0.55, 0.27 * p[1]], "
                                      "material: ink }.rotate(turn)\n  for p in pips(n)\n]\n");
}

TEST_CASE("format: an if with blocks in a comprehension is no clause of it") {
  const std::string value = "if a { 1 } else if b { 2 } else { 3 }";
  const std::string clause = "for i in " + numbers(10000, 10);
  const std::string broken = "x = [\n  " + value + "\n  " + clause + "\n  if i < 3\n]\n";
  CHECK(formatted("x = [" + value + " " + clause + " if i < 3]") == broken);
  CHECK(formatted("x = [\n" + value + "\n" + clause + "\nif i < 3]") == broken);
}

TEST_CASE("format: a list is filled up to the 100th column wherever it comes to stand") {
  // With four columns of indentation fourteen of the numbers take exactly 100, with six they are one too many: the list
  // is filled before what is around it is broken, and moves.
  std::string call = numbers(10000, 13);
  call.front() = '(', call.back() = ')';
  CHECK(formatted("x = [f" + call + " for i in [\n" + numbers(10000, 15) + "]]") ==
        "x = [\n  f" + call +
            "\n  for i in [\n    [\n      10000, 10001, 10002, 10003, 10004, 10005, 10006, 10007, 10008, " +
            "10009, 10010, 10011, 10012\n      10013, 10014\n    ]\n  ]\n]\n");
}

TEST_CASE("format: a line break that is not kept does not keep others from being set") {
  std::string list = numbers(1000, 16);
  list.back() = ',';
  const std::string broken = formatted("x = " + list + " f(1, 2)]");
  CHECK(broken.ends_with(" 1015\n  f(1, 2)\n]\n"));
  CHECK(formatted("x = " + list + " f(1\n, 2)]") == broken);
  CHECK(formatted("x = " + list + " [1\n, 2]]") == formatted("x = " + list + " [1, 2]]"));
}

TEST_CASE("format: an item that cannot begin a line keeps the comma before it") {
  CHECK(formatted("fn f(x) { y = x, -y // minus\n}") == "fn f(x) {\n  y = x,\n  -y // minus\n}\n");
  CHECK(formatted("fn f(x) {\n y = x, // y\n { a: y } }") == "fn f(x) {\n  y = x, // y\n  { a: y }\n}\n");
  CHECK(formatted("fn f(x) { -x }") == "fn f(x) { -x }\n");
}

TEST_CASE("format: lists keep their lines") {
  CHECK(formatted("m = [[1,0],\n [0,1]]") == "m = [\n  [1, 0]\n  [0, 1]\n]\n");
  CHECK(formatted("m = [\n1,0,\n\n0,1]") == "m = [\n  1, 0\n\n  0, 1\n]\n");
}

TEST_CASE("format: comments stay where they are") {
  CHECK(formatted("// head\n\n\n\na: 1 // one\n// own\nb: 2 /* two */\n") ==
        "// head\n\na: 1 // one\n// own\nb: 2 /* two */\n");
  CHECK(formatted("sphere { // ball\nradius: 2, // r\n// last\n}") ==
        "sphere { // ball\n  radius: 2 // r\n  // last\n}\n");
  CHECK(formatted("f(1, // one\n2 // two\n, 3)") == "f(1, // one\n  2, // two\n  3)\n");
  CHECK(formatted("x = a + // first\n b") == "x = a + // first\n  b\n");
  CHECK(formatted("box {}\n// turned\n.rotate(y: 3)") == "box {}\n  // turned\n  .rotate(y: 3)\n");
  CHECK(formatted("x = /* a */ 1") == "x = /* a */ 1\n");
  const std::string long_comment = "a: [1, 2] // " + std::string(120, 'x') + "\n";
  CHECK(formatted(long_comment) == long_comment);
}

TEST_CASE("format: signs that were aligned stay aligned, as close as they can") {
  CHECK(formatted("a     = 1\nlong  = 2\n") == "a    = 1\nlong = 2\n");
  CHECK(formatted("camera { at: 1 }\nsun    { at: 2 }\n") == "camera { at: 1 }\nsun    { at: 2 }\n");
  CHECK(formatted("a   = 1\nlong   = 2\n") == "a = 1\nlong = 2\n");
  CHECK(formatted("a     = 1\n\nlong  = 2\n") == "a = 1\n\nlong = 2\n");
}

TEST_CASE("format: comments behind lines that were aligned stay aligned, as close as they can") {
  CHECK(formatted("a = 1     // one\nlong = 2  // two\n") == "a = 1    // one\nlong = 2 // two\n");
  CHECK(formatted("a=1 // one\nlong = 2 // two\n") == "a = 1 // one\nlong = 2 // two\n");
  CHECK(formatted("a = 1     // one\n\nlong = 2  // two\n") == "a = 1 // one\n\nlong = 2 // two\n");
  CHECK(formatted("s = \"é\"  // one\nlo = 2   // two\nb = 3\nc = 4  // four\n") ==
        "s = \"é\" // one\nlo = 2  // two\nb = 3\nc = 4 // four\n");
  CHECK(formatted("group {\n  box {}      // one\n  sphere{}    // two\n}\n") ==
        "group {\n  box {}    // one\n  sphere {} // two\n}\n");
  CHECK(formatted("p = [\n[0,0]    // a\n[1,0.25] // b\n]\n") == "p = [\n  [0, 0]    // a\n  [1, 0.25] // b\n]\n");
}

TEST_CASE("format: Windows' line endings and a byte order mark go") {
  CHECK(formatted("\xef\xbb\xbf"
                  "a: 1\r\n/* x\r\ny */\r\nb: 2 // c\r\n") == "a: 1\n/* x\ny */\nb: 2 // c\n");
}

TEST_CASE("format: a text with syntax errors stays as it is") {
  SourceMap sources;
  const Formatted out = format(sources, sources.add("a.rtl", "", "sphere{ radius 2 }"));
  CHECK(out.text == "sphere{ radius 2 }");
  CHECK(out.diagnostics.size() == 1);
}

TEST_CASE("format: random programs keep their meaning and their comments, and formatting is idempotent") {
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    const std::string text = RandomProgram(seed).text(1 + static_cast<int>(seed % 5));
    INFO("seed " << seed << "\n" << text);
    REQUIRE(parse_text(text).report().empty());
    check_promises(text);
  }
}

TEST_CASE("format: every example keeps its meaning, and formatting is idempotent") {
  int count = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::string(RTLANG_SOURCE_DIR) + "/examples")) {
    if (entry.path().extension() != ".rtl") continue;
    std::ifstream in(entry.path());
    std::ostringstream text;
    text << in.rdbuf();
    INFO(entry.path());
    check_promises(text.str());
    ++count;
  }
  CHECK(count > 0);
}

TEST_CASE("format: numbers keep the way they are written, and their distance from dots") {
  CHECK(formatted("x = [.5,5.,+60]\n") == "x = [.5, 5., +60]\n");
  CHECK(formatted("y = 1. .. +3\n") == "y = 1. ..+3\n");
  CHECK(formatted("z = 1 .. .5\n") == "z = 1.. .5\n");
  CHECK(formatted("w = + x + +y\n") == "w = +x + +y\n");
}
