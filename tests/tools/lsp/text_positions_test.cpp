#include "tools/lsp/text_positions.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace rt::tools::lsp;

namespace {

std::string shown(const TextPosition& p) {
  return std::to_string(p.line) + ":" + std::to_string(p.character);
}

} // namespace

TEST_CASE("positions: characters count in UTF-16 units, or in bytes") {
  // The sphere is one unit of UTF-16 and 3 bytes, the emoji two units and 4 bytes.
  const std::string text = "a●b\n// 🙂 x\n";
  const LineTable lines(text);
  const std::size_t b = text.find('b'), x = text.find('x');
  CHECK(shown(lines.position(b, PositionEncoding::utf16)) == "0:2");
  CHECK(shown(lines.position(b, PositionEncoding::utf8)) == "0:4");
  CHECK(shown(lines.position(x, PositionEncoding::utf16)) == "1:6");
  CHECK(shown(lines.position(x, PositionEncoding::utf8)) == "1:8");
  CHECK(lines.offset({0, 2}, PositionEncoding::utf16) == b);
  CHECK(lines.offset({1, 6}, PositionEncoding::utf16) == x);
  CHECK(lines.offset({1, 8}, PositionEncoding::utf8) == x);
  // Within a character is before it.
  CHECK(lines.offset({1, 4}, PositionEncoding::utf16) == text.find("🙂"));
}

TEST_CASE("positions: a line ends with any of the three ends, and what lies beyond is the end") {
  const std::string text = "one\r\ntwo\rthree\n";
  const LineTable lines(text);
  CHECK(shown(lines.position(text.find("two"), PositionEncoding::utf16)) == "1:0");
  CHECK(shown(lines.position(text.find("three"), PositionEncoding::utf16)) == "2:0");
  CHECK(shown(lines.position(text.size(), PositionEncoding::utf16)) == "3:0");
  CHECK(shown(lines.position(text.size() + 9, PositionEncoding::utf16)) == "3:0");
  CHECK(lines.offset({0, 99}, PositionEncoding::utf16) == 3);
  CHECK(lines.offset({1, 99}, PositionEncoding::utf16) == 8);
  CHECK(lines.offset({9, 0}, PositionEncoding::utf16) == text.size());
  CHECK(LineTable("").offset({0, 0}, PositionEncoding::utf16) == 0);
}

TEST_CASE("positions: bytes that are no UTF-8 count one each") {
  const std::string text = "\xff\xfe x";
  const LineTable lines(text);
  CHECK(shown(lines.position(3, PositionEncoding::utf16)) == "0:3");
  CHECK(lines.offset({0, 3}, PositionEncoding::utf16) == 3);
}
