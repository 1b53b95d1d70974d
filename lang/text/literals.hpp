#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// A number literal's value. `length` is how many bytes belong to the number itself; a suffix follows.
struct NumberLiteral {
  double value;
  std::uint32_t length;
};
/// Whether a text begins with a digit, or a point and a digit.
bool begins_number(std::string_view text);
/// `2`, `.5`, `5.`, `1e-3`, rounded to the nearest double as the C++ library does. Requires a text that begins a
/// number.
NumberLiteral read_number(std::string_view text);
/// The same with a sign before it, or without; the length is 0 where no number follows.
NumberLiteral read_signed_number(std::string_view text);

/// What one of `suffix` is in degrees; 0 where there is no such unit.
double degrees_per(std::string_view suffix);

/// A string literal without its quotes, escapes resolved. `bad_escapes` gets the offset of each escape that has no
/// meaning.
std::string read_string(std::string_view text, std::vector<std::uint32_t>& bad_escapes);

/// The literal that says `text`, quotes and all.
std::string write_string(std::string_view text);

/// `rgb` or `rrggbb` in hexadecimal as 0xrrggbb. Requires 3 or 6 hexadecimal digits.
std::uint32_t read_color(std::string_view digits);

} // namespace rt::lang
