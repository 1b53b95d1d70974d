#include "tests/support/parsing.hpp"

#include <catch2/catch.hpp>

#include <numbers>

using namespace rt::lang;
using rt::tests::parse_text;
using rt::tests::parsed;
using rt::tests::shape;

TEST_CASE("grammar: no rule can loop without consuming input") {
  CHECK(grammar_problems() == 0);
}

TEST_CASE("parse: an empty file, blank lines and comments hold no items") {
  CHECK(parsed("") == "");
  CHECK(parsed("\n\n  \t\n") == "");
  CHECK(parsed("// a\n/* b\n c */ // d\n") == "");
  CHECK(parsed("// no newline at the end") == "");
}

TEST_CASE("parse: properties, bindings and things") {
  CHECK(parsed("ambient: 0.1") == "ambient: 0.1");
  CHECK(parsed("x = 2") == "(= x 2)");
  CHECK(parsed("sphere") == "sphere");
  CHECK(parsed("sphere {}") == "sphere{}");
  CHECK(parsed("sphere { radius: 2, at: [1, 2, 3] }") == "sphere{radius: 2; at: [1 2 3]}");
  CHECK(parsed("wood = material { color: peru }") == "(= wood material{color: peru})");
}

TEST_CASE("parse: comma, newline and semicolon separate alike, and may end a block") {
  const std::string expected = "sphere{a: 1; b: 2}";
  CHECK(parsed("sphere { a: 1, b: 2 }") == expected);
  CHECK(parsed("sphere { a: 1; b: 2; }") == expected);
  CHECK(parsed("sphere { a: 1,\n\n b: 2,\n}") == expected);
  CHECK(parsed("sphere {\n a: 1\n b: 2\n}") == expected);
  CHECK(parsed("sphere {\n a: 1 // one\n\n // two\n b: 2 /* three */\n}") == expected);
  CHECK(parsed("sphere {\n a: 1\n , b: 2 }") == expected);
  CHECK(parsed("a = 1; b = 2") == "(= a 1); (= b 2)");
}

TEST_CASE("parse: numbers, units and signs") {
  CHECK(parsed("x = 0.5") == "(= x 0.5)");
  CHECK(parsed("x = 1e3") == "(= x 1000)");
  CHECK(parsed("x = 2.5e-1") == "(= x 0.25)");
  CHECK(parsed("x = 30deg") == "(= x 30)");
  CHECK(parsed("x = 0.25turn") == "(= x 90)");
  CHECK(parsed("x = -3.5") == "(= x -3.5)");
  CHECK(parsed("x = - 3.5") == "(= x -3.5)");
  const auto half_turn = parse_text("x = 3.141592653589793rad");
  const Ast& ast = half_turn.ast();
  CHECK(ast.number(ast.bind_item(ast.children(ast.root)[0]).value) == Approx(180).epsilon(1e-15));
}

TEST_CASE("parse: a list of number literals is one node") {
  CHECK(parsed("x = [1, -2, 3.5]") == "(= x [1 -2 3.5])");
  const auto text = parse_text("x = [1, -2, 3.5]");
  CHECK(text.ast().constants == std::vector<double>{1, -2, 3.5});
  CHECK(text.ast().kind(text.ast().bind_item(text.ast().children(text.ast().root)[0]).value) == Kind::numbers);
  CHECK(parsed("x = [1, a, 3]") == "(= x [1 a 3])");
  CHECK(parsed("x = []") == "(= x [])");
  CHECK(parsed("x = [[1, 2], [3, 4]]") == "(= x [[1 2] [3 4]])");
  CHECK(parsed("x = [1 + 2, 3]") == "(= x [(+ 1 2) 3])");
}

TEST_CASE("parse: newlines separate the elements of a list") {
  CHECK(parsed("x = [1\n 2\n\n 3 // three\n]") == "(= x [1 2 3])");
  CHECK(parsed("x = [\n  1, 2,\n  3,\n]") == "(= x [1 2 3])");
  CHECK(parsed("x = [\n  -1\n  -2\n]") == "(= x [-1 -2])");
  CHECK(parsed("x = [\n  { a: 1 }\n  { a: 2 }\n]") == "(= x [{a: 1} {a: 2}])");
}

TEST_CASE("parse: newlines are white space in parentheses, and in blocks within them separate again") {
  CHECK(parsed("x = (1\n + 2\n)") == "(= x (+ 1 2))");
  CHECK(parsed("f(\n  1,\n  a: 2,\n)") == "(call f 1 a: 2)");
  CHECK(parsed("x = (box { a: 1\n b: 2 }\n - sphere {})") == "(= x (- box{a: 1; b: 2} sphere{}))");
  CHECK(parsed("x = f([1\n 2])") == "(= x (call f [1 2]))");
}

TEST_CASE("parse: colours and strings") {
  CHECK(parsed("c = #f80") == "(= c #ff8800)");
  CHECK(parsed("c = #12aBcD") == "(= c #12abcd)");
  CHECK(parsed(R"(s = "a\"b\\c\td")") == "(= s \"a\"b\\c\td\")");
  CHECK(parsed(R"(s = "\u{e9}\u{1F388}")") == "(= s \"é🎈\")");
  CHECK(parsed("s = \"größe // no comment\"") == "(= s \"größe // no comment\")");
}

TEST_CASE("parse: operators bind in the order of the language's table") {
  CHECK(parsed("x = 1 + 2 * 3") == "(= x (+ 1 (* 2 3)))");
  CHECK(parsed("x = 1 - 2 - 3") == "(= x (- (- 1 2) 3))");
  CHECK(parsed("x = a | b - c & d") == "(= x (- (| a b) (& c d)))");
  CHECK(parsed("x = 8 / 4 * 2 % 3") == "(= x (% (* (/ 8 4) 2) 3))");
  CHECK(parsed("x = a or b and not c == d") == "(= x (or a (and b (not (== c d)))))");
  CHECK(parsed("x = a < b + 1") == "(= x (< a (+ b 1)))");
  CHECK(parsed("x = a and b or c") == "(= x (or (and a b) c))");
  CHECK(parsed("x = not not a") == "(= x (not (not a)))");
  CHECK(parsed("x = (1 + 2) * 3") == "(= x (* (+ 1 2) 3))");
}

TEST_CASE("parse: a power binds tighter than a sign, to the right, and takes a signed exponent") {
  CHECK(parsed("x = -2 ^ 2") == "(= x (- (^ 2 2)))");
  CHECK(parsed("x = 2 ^ -3") == "(= x (^ 2 -3))");
  CHECK(parsed("x = 2 ^ 3 ^ 4") == "(= x (^ 2 (^ 3 4)))");
  CHECK(parsed("x = 2 ^ -3 ^ 4") == "(= x (^ 2 (- (^ 3 4))))");
  CHECK(parsed("x = 2 * -a") == "(= x (* 2 (- a)))");
  CHECK(parsed("x = -a * b") == "(= x (* (- a) b))");
  CHECK(parsed("x = a - -b") == "(= x (- a (- b)))");
  CHECK(parsed("x = -a.y") == "(= x (- (. a y)))");
  CHECK(parsed("x = a ^ b.y") == "(= x (^ a (. b y)))");
}

TEST_CASE("parse: ranges bind looser than sums and tighter than comparisons") {
  CHECK(parsed("x = 0..10") == "(= x (.. 0 10 _))");
  CHECK(parsed("x = 0..<n - 1 by 2 * k") == "(= x (..< 0 (- n 1) (* 2 k)))");
  CHECK(parsed("x = 1..2 == y") == "(= x (== (.. 1 2 _) y))");
  CHECK(parsed("x = 1.5..2.5") == "(= x (.. 1.5 2.5 _))");
}

TEST_CASE("parse: suffixes follow each other") {
  CHECK(parsed("x = f(1)(2)[3].y") == "(= x (. (index (call (call f 1) 2) 3) y))");
  CHECK(parsed("table { width: 3 }.rotate(y: 30).move([1, 0, 0])") ==
        "(call (. (call (. table{width: 3} rotate) y: 30) move) [1 0 0])");
  CHECK(parsed("(a - b) { material: glass }") == "(- a b){material: glass}");
  CHECK(parsed("lib.lamp { at: 1 }") == "(. lib lamp){at: 1}");
}

TEST_CASE("parse: a line that begins with a dot continues the item before it") {
  CHECK(parsed("box {}\n  .scale(2)\n  // turned\n  .rotate(y: 30)\nsphere {}") ==
        "(call (. (call (. box{} scale) 2) rotate) y: 30); sphere{}");
  CHECK(parsed("x = box {}\n.scale(2)") == "(= x (call (. box{} scale) 2))");
}

TEST_CASE("parse: an operator, a comma, a colon or an equals sign at a line's end continues it") {
  CHECK(parsed("x = 1 +\n  2") == "(= x (+ 1 2))");
  CHECK(parsed("x = a and // both\n  b") == "(= x (and a b))");
  CHECK(parsed("x =\n  1") == "(= x 1)");
  CHECK(parsed("sphere { at:\n [1, 2, 3] }") == "sphere{at: [1 2 3]}");
}

TEST_CASE("parse: the head of for and if ends where the block begins") {
  CHECK(parsed("for x in xs { sphere {} }") == "(for _ x xs {sphere{}})");
  CHECK(parsed("for i, a in 0..<360 by 30 { sphere { at: a } }") == "(for i a (..< 0 360 30) {sphere{at: a}})");
  CHECK(parsed("if x { a: 1 }") == "(if x {a: 1} _)");
  CHECK(parsed("if (f { a: 1 }).b { c: 2 }") == "(if (. f{a: 1} b) {c: 2} _)");
  CHECK(parsed("for s in [sphere { radius: 1 }] { s }") == "(for _ s [sphere{radius: 1}] {s})");
}

TEST_CASE("parse: if is an item and an expression") {
  CHECK(parsed("if a { b: 1 } else if c { d: 2 } else { e: 3 }") == "(if a {b: 1} (if c {d: 2} {e: 3}))");
  CHECK(parsed("x = if a { 1 } else { -1 }") == "(= x (if a {1} {-1}))");
  CHECK(parsed("x = if a {\n  y = 2\n  y * 3\n} else {\n  -1\n}") == "(= x (if a {(= y 2); (* y 3)} {-1}))");
  CHECK(parsed("x = 1 + (if a { 1 } else { 2 })") == "(= x (+ 1 (if a {1} {2})))");
}

TEST_CASE("parse: declarations") {
  CHECK(parsed("def table(width = 2, height = 1) { box {} }") == "(def table (width=2 height=1) {box{}})");
  CHECK(parsed("def ball() { }") == "(def ball () {})");
  CHECK(parsed("fn wave(a) = 0.3 * sin(3 * a)") == "(fn wave (a) (* 0.3 (call sin (* 3 a))))");
  CHECK(parsed("fn f(a, b = a) {\n  c = a + b\n  c ^ 2\n}") == "(fn f (a b=a) {(= c (+ a b)); (^ c 2)})");
  CHECK(parsed("include \"a.rtl\"") == "(include a.rtl)");
  CHECK(parsed("use \"lib/a.rtl\" as a") == "(use lib/a.rtl a)");
  CHECK(parsed("param n = 3") == "(param n 3 _)");
  CHECK(parsed("param n = 3 in 1..10") == "(param n 3 (.. 1 10 _))");
}

TEST_CASE("parse: functions without a name, records and comprehensions") {
  CHECK(parsed("f = fn (x, y = 2) => x * y") == "(= f (lambda _ (x y=2) (* x y)))");
  CHECK(parsed("x = map(fn (x) => x + 1, xs)") == "(= x (call map (lambda _ (x) (+ x 1)) xs))");
  CHECK(parsed("p = { x: 1, y: 2 }") == "(= p {x: 1, y: 2})");
  CHECK(parsed("p = {}") == "(= p {})");
  CHECK(parsed("x = [a * b for a in xs for i, b in ys if a < b]") ==
        "(= x [(* a b) (clause _ a xs _) (clause i b ys _) (filter (< a b))])");
  CHECK(parsed("x = [\n  a\n  for a in xs\n  if a > 1\n]") == "(= x [a (clause _ a xs _) (filter (> a 1))])");
}

TEST_CASE("parse: words that begin like reserved ones are names, and so are words of other languages") {
  CHECK(parsed("format = 1") == "(= format 1)");
  CHECK(parsed("order = nothing") == "(= order nothing)");
  CHECK(parsed("let = 1") == "(= let 1)");
  CHECK(parsed("function { var: 1 }") == "function{var: 1}");
}

TEST_CASE("parse: line endings of Windows and a byte order mark change nothing") {
  CHECK(parsed("\xef\xbb\xbfsphere {\r\n  a: 1\r\n  b: 2\r\n}\r\n// end\r\n") == "sphere{a: 1; b: 2}");
}

TEST_CASE("parse: spans are those of the text") {
  const auto text = parse_text("x = -f(1, a: 2).y + (3)\n");
  const Ast& ast = text.ast();
  const BindItem bind = ast.bind_item(ast.children(ast.root)[0]);
  const auto said = [&](NodeId id) { return text.sources.text(ast.span(id)); };
  CHECK(said(ast.children(ast.root)[0]) == "x = -f(1, a: 2).y + (3)");
  CHECK(said(bind.name) == "x");
  const NodeId minus = ast.left(bind.value);
  CHECK(said(minus) == "-f(1, a: 2).y");
  const NodeId member = ast.operand(minus);
  CHECK(said(member) == "f(1, a: 2).y");
  CHECK(text.sources.text(ast.member_span(member, text.symbols)) == "y");
  const Call call = ast.call(ast.member(member).base);
  CHECK(said(call.arguments[1]) == "a: 2");
  CHECK(text.sources.text(ast.named_span(call.arguments[1], text.symbols)) == "a");
}

TEST_CASE("parse: an expression alone") {
  SourceMap sources;
  SymbolTable symbols;
  const FileId good = sources.add("-D", "", " [1, 2] + x ");
  const Parsed sum = parse_expression(sources, good, symbols);
  CHECK(sum.diagnostics.empty());
  CHECK(shape(sum.ast, symbols, sum.ast.root) == "(+ [1 2] x)");
  for (const char* wrong : {"", "1 2", "x: 1", "(1", "1 +"}) {
    INFO(wrong);
    const Parsed failed = parse_expression(sources, sources.add("-D", "", wrong), symbols);
    CHECK(failed.diagnostics.size() == 1);
    CHECK(failed.ast.kind(failed.ast.root) == Kind::error);
  }
}

TEST_CASE("parse: in a session the first line may begin with a dot") {
  const ParseOptions session{.is_session = true};
  const auto text = parse_text(".move(x: 2).scale(3)\n", session);
  CHECK(text.codes().empty());
  CHECK(shape(text) == "(call (. (call (. previous move) x: 2) scale) 3)");
  CHECK(parse_text(".move(x: 2)").codes() == std::vector<std::string>{"E0114"});
  CHECK(parse_text("sphere {}; .move(x: 2)", session).codes() == std::vector<std::string>{"E0114"});
}

TEST_CASE("parse: a session knows when a text is complete") {
  for (const char* complete :
       {"", "sphere {}", "x = 1", "f(\n1\n)", "x = true", "a /* b */", "// x =", "x = 1;", ")", "s = \"{\""}) {
    INFO(complete);
    CHECK(is_complete(complete));
  }
  for (const char* open : {"sphere {", "x =", "x = 1 +", "f(1,", "a:", "x = a and", "x = [1\n", "/* a",
                           "x = 1 + // one", "x = not", "for", "a."}) {
    INFO(open);
    CHECK_FALSE(is_complete(open));
  }
}
