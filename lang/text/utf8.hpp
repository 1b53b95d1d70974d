#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rt::lang {

/// One character at the start of a text: its code point (U+FFFD where the bytes are no UTF-8) and how many bytes it
/// takes.
struct Character {
  char32_t code_point = 0;
  std::size_t bytes = 1;
  bool is_valid = true;
};

/// Requires a text that is not empty. Overlong forms, surrogates and what lies beyond U+10FFFF are invalid, one byte
/// each.
Character decode(std::string_view text);

void append_utf8(std::string& out, char32_t code_point);

/// Where the first bytes stand that are no UTF-8.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// How many columns of a terminal a character takes: 0 for combining marks, 2 for ideographs and emoji.
int display_width(char32_t code_point);
/// The same for a whole text.
std::size_t display_width(std::string_view text);

/// Whether a terminal would obey the character instead of showing it: control characters and direction overrides.
bool is_control(char32_t code_point);

} // namespace rt::lang
