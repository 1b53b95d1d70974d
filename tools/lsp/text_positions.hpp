#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rt::tools::lsp {

/// The unit of a position's character: bytes, or 16-bit units of UTF-16 (LSP 3.17, "PositionEncodingKind").
enum class PositionEncoding : std::uint8_t { utf8, utf16 };

/// A place between two characters. Lines and characters are counted from 0.
struct TextPosition {
  std::uint32_t line = 0, character = 0;
};

/// Where the lines of a text begin, by the protocol's rules: a line ends with \n, \r\n or \r. The text must outlive it.
class LineTable {
public:
  explicit LineTable(std::string_view text);

  /// The position of a byte offset; clamped to the end of the text.
  TextPosition position(std::size_t offset, PositionEncoding encoding) const;
  /// The byte offset. A character beyond its line is the line's end, a line beyond the last the text's, and the middle
  /// of a character its beginning.
  std::size_t offset(TextPosition position, PositionEncoding encoding) const;

private:
  std::string_view text_;
  std::vector<std::size_t> starts_;
};

} // namespace rt::tools::lsp
