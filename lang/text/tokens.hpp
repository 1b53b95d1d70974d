#pragma once

#include <cstdint>
#include <string_view>

namespace rt::lang {

enum class TokenKind : std::uint8_t {
  end,
  newline,
  line_comment,
  block_comment,
  name,   ///< reserved words too
  number, ///< with its suffix
  color,
  string,    ///< up to the end of the line where it is not closed
  open,      ///< ( [ {
  close,     ///< ) ] }
  separator, ///< , ;
  symbol,    ///< operators, = : . =>
  unknown,
};

/// A stretch of text that stands for one thing; byte offsets.
struct Token {
  TokenKind kind;
  std::uint32_t begin;
  std::uint32_t end;
};

/// The token that starts at `at` or after the blanks there. It takes any text, well formed or not: it serves where the
/// grammar cannot, in finding the way on after a mistake, in sessions and in the formatter.
Token next_token(std::string_view text, std::uint32_t at);

/// What the token says.
inline std::string_view text_of(std::string_view text, Token token) {
  return text.substr(token.begin, token.end - token.begin);
}

} // namespace rt::lang
