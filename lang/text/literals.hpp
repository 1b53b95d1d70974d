#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// The value of a number literal. `length` is the number of bytes of the number itself; a suffix may follow.
struct NumberLiteral {
  double value;
  std::uint32_t length;
};
/// Whether a text begins with a digit, or a point and a digit.
bool begins_number(std::string_view text);
/// `2`, `.5`, `5.`, `1e-3`, rounded to the nearest double as the C++ library does. Requires a text that begins a
/// number.
NumberLiteral read_number(std::string_view text);
/// The same with an optional sign; the length is 0 if no number follows.
NumberLiteral read_signed_number(std::string_view text);

/// How many degrees one `suffix` is; 0 if there is no such unit.
double degrees_per(std::string_view suffix);

/// The content of a string literal without its quotes, escapes resolved. `bad_escapes` receives the offset of each
/// invalid escape.
std::string read_string(std::string_view text, std::vector<std::uint32_t>& bad_escapes);

/// The literal for `text`, including quotes.
std::string write_string(std::string_view text);

/// `rgb` or `rrggbb` in hexadecimal as 0xrrggbb. Requires 3 or 6 hexadecimal digits.
std::uint32_t read_color(std::string_view digits);

} // namespace rt::lang
