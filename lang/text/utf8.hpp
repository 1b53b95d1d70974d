#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rt::lang {

/// One character at the start of a text: its code point (U+FFFD if the bytes are not valid UTF-8) and its length in
/// bytes.
struct Character {
  char32_t code_point = 0;
  std::size_t bytes = 1;
  bool is_valid = true;
};

/// Requires a text that is not empty. Overlong forms, surrogates and code points beyond U+10FFFF are invalid, one byte
/// each.
Character decode(std::string_view text);

void append_utf8(std::string& out, char32_t code_point);

/// The position of the first bytes that are not valid UTF-8.
std::optional<std::size_t> find_invalid_utf8(std::string_view text);

/// How many columns of a terminal a character takes: 0 for combining marks, 2 for ideographs and emoji.
int display_width(char32_t code_point);
/// The same for a whole text.
std::size_t display_width(std::string_view text);

/// Whether a terminal would interpret the character instead of showing it: control characters and direction overrides.
bool is_control(char32_t code_point);

} // namespace rt::lang
