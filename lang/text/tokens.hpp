#pragma once

#include <cstdint>
#include <string_view>

namespace rt::lang {

enum class TokenKind : std::uint8_t {
  end,
  newline,
  line_comment,
  block_comment,
  name,   ///< including reserved words
  number, ///< with its suffix
  color,
  string,    ///< to the end of the line if it is not closed
  open,      ///< ( [ {
  close,     ///< ) ] }
  separator, ///< , ;
  symbol,    ///< operators, = : . =>
  unknown,
};

/// A lexical unit of the text; byte offsets.
struct Token {
  TokenKind kind;
  std::uint32_t begin;
  std::uint32_t end;
};

/// The token that starts at `at` or after the blanks there. It accepts any text, well formed or not: it is used where
/// the grammar cannot be, for error recovery, in sessions and in the formatter.
Token next_token(std::string_view text, std::uint32_t at);

/// The token's text.
inline std::string_view text_of(std::string_view text, Token token) {
  return text.substr(token.begin, token.end - token.begin);
}

} // namespace rt::lang
