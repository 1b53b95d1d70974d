#include "lang/syntax/repeat_text.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace rt::lang;

namespace {

std::vector<std::string> pieces(std::string_view item, const std::vector<double>& literals) {
  const std::optional<RepeatText> wording = RepeatText::of(item, literals);
  std::vector<std::string> found;
  if (!wording) return found;
  for (std::size_t i = 0; i <= wording->numbers(); ++i) found.emplace_back(wording->piece(i));
  return found;
}

} // namespace

TEST_CASE("wording: what stands between the numbers") {
  using Pieces = std::vector<std::string>;
  CHECK(pieces("sphere { at: [1, -2.5 ,3e2] }", {1, -2.5, 300}) == Pieces{"sphere { at: [", ", ", " ,", "] }"});
  CHECK(pieces("a1.b2 { c3: 4; d: e5\n}", {4}) == Pieces{"a1.b2 { c3: ", "; d: e5\n}"});
  CHECK(pieces("a { b: [.5, +6, 7.]\n}", {.5, 6, 7}) == Pieces{"a { b: [", ", ", ", ", "]\n}"});
  CHECK(pieces("a { b: c }", {}) == Pieces{"a { b: c }"});
  CHECK(pieces("a { b: 1\n}", {1}) == Pieces{"a { b: ", "\n}"});
}

TEST_CASE("wording: none where a number may be part of something else, or is not what the grammar found") {
  for (const char* item : {"a { b: 1 + 1 }",   "a { b: 1 - 1 }", "a { b: 1..1 }",  "a { b: 1turn }",
                           "a { b: 1.x }",     "a { b: (1) }",   "a { b: \"1\" }", "a { b: #111 }",
                           "a { b: 1 // 1\n}", "a { b: [\n1] }", "a { b: x - 1 }", "a { b: x -1 }",
                           "a { b: -x }",      "a { b: - 1 }",   "a { b: 1\n.x }", "a { b: [1\n, 1\n \n{}] }",
                           "a { 1 }",          "a { b: 1[0] }",  "a { b: 1 }.c",   "a { b: '1' }",
                           "a { b: -1 ^ 1 }",  "a { b: +1 + 1 }"}) {
    INFO(item);
    CHECK(pieces(item, {1}).empty());
    CHECK(pieces(item, {1, 1}).empty());
    CHECK(pieces(item, {-1}).empty());
  }
  CHECK(pieces("a { b: 1 }", {}).empty());
  CHECK(pieces("a { b: 1 }", {2}).empty());
  CHECK(pieces("a { b: -0 }", {0}).empty());
  CHECK(pieces("a { b: 1 }", {1, 1}).empty());
  CHECK(pieces("", {}).empty());
}

TEST_CASE("wording: an item ends at a comma or a line's end that nothing continues") {
  for (const char* rest : {"", "  ", ",", " ;", " }", "\n", "\nsphere {}", "\r\n \n\t box", "\n}", "\n-1", "\n| b"})
    CHECK(ends_item(rest, 0));
  for (const char* rest :
       {"x", " {", ".at", " | b", "\n.at", "\n \n  .at", "\n{", "\n// c\n.at", "# c", "// c", "(", "["})
    CHECK_FALSE(ends_item(rest, 0));
}
