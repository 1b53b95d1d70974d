#include "lang/text/literals.hpp"

#include "lang/text/characters.hpp"
#include "lang/text/utf8.hpp"

#include <charconv>
#include <limits>
#include <numbers>

namespace rt::lang {

namespace {

// The powers of ten that are exact doubles.
constexpr double exact_power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t exact_limit = std::uint64_t{1} << 53;

double read_slowly(std::string_view text) {
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc::result_out_of_range) return value;
  // Overflow or underflow: the exponent's sign tells which.
  const std::size_t e = text.find_first_of("eE");
  const bool is_small = e != std::string_view::npos ? text[e + 1] == '-' : text.find_first_of("123456789") > 300;
  return is_small ? 0 : std::numeric_limits<double>::infinity();
}

int hex_value(char c) {
  if (is_digit(c)) return c - '0';
  return (c | 0x20) - 'a' + 10;
}

// Where the digits of the exponent that begins at `at` are; 0 if there is none.
std::size_t exponent_digits(std::string_view text, std::size_t at) {
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return 0;
  const std::size_t digits = at + 1 + (at + 1 < text.size() && is_sign(text[at + 1]) ? 1 : 0);
  return digits < text.size() && is_digit(text[digits]) ? digits : 0;
}

// Whether the point at `at` belongs to the digits before it: not that of `1..2`, nor that of `1.x`.
bool owns_point(std::string_view text, std::size_t at) {
  const char next = at + 1 < text.size() ? text[at + 1] : '\0';
  return (next != '.' && !is_name_start(next)) || exponent_digits(text, at + 1) > 0;
}

} // namespace

// A mantissa below 2^53 and a power of ten up to 22 are exact, and one multiplication or division rounds once, to the
// nearest (Clinger, How to Read Floating Point Numbers Accurately, 1990); everything else goes to the library.
NumberLiteral read_number(std::string_view text) {
  const auto digit_at = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
  std::uint64_t mantissa = 0;
  int digits = 0, scale = 0;
  std::size_t at = 0;
  const auto take = [&] {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(text[at++] - '0');
    ++digits;
  };
  while (digit_at(at)) take();
  if (at < text.size() && text[at] == '.' && owns_point(text, at)) {
    for (++at; digit_at(at); --scale) take();
  }
  if (std::size_t i = exponent_digits(text, at); i > 0) {
    int exponent = 0;
    for (; digit_at(i); ++i) exponent = exponent > 9999 ? exponent : exponent * 10 + (text[i] - '0');
    scale += text[at + 1] == '-' ? -exponent : exponent;
    at = i;
  }
  const auto length = static_cast<std::uint32_t>(at);
  if (digits > 19 || mantissa > exact_limit || scale > 22 || scale < -22)
    return {read_slowly(text.substr(0, at)), length};
  const auto whole = static_cast<double>(mantissa);
  return {scale < 0 ? whole / exact_power[-scale] : whole * exact_power[scale], length};
}

bool begins_number(std::string_view text) {
  if (text.empty()) return false;
  return is_digit(text[0]) || (text[0] == '.' && text.size() > 1 && is_digit(text[1]));
}

NumberLiteral read_signed_number(std::string_view text) {
  const std::uint32_t sign = !text.empty() && is_sign(text[0]) ? 1 : 0;
  if (text.size() <= sign) return {0, 0};
  if (!is_digit(text[sign]) && !begins_number(text.substr(sign))) return {0, 0};
  const NumberLiteral number = read_number(text.substr(sign));
  return {text[0] == '-' ? -number.value : number.value, sign + number.length};
}

double degrees_per(std::string_view suffix) {
  if (suffix == "deg") return 1;
  if (suffix == "rad") return 180 / std::numbers::pi;
  if (suffix == "turn") return 360;
  return 0;
}

std::string read_string(std::string_view text, std::vector<std::uint32_t>& bad_escapes) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      out += text[i];
      continue;
    }
    const std::size_t begin = i++;
    const char c = i < text.size() ? text[i] : '\0';
    if (c == 'n' || c == 't') {
      out += c == 'n' ? '\n' : '\t';
    } else if (c == '"' || c == '\\') {
      out += c;
    } else if (c == 'u' && i + 1 < text.size() && text[i + 1] == '{') {
      const std::size_t close = text.find('}', i);
      std::uint32_t code = 0;
      const char* const first = text.data() + i + 2;
      const char* const last = text.data() + std::min(close, text.size());
      const auto result = std::from_chars(first, last, code, 16);
      const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
      const bool is_read =
          close != std::string_view::npos && first != last && result.ec == std::errc{} && result.ptr == last;
      if (is_read && code <= 0x10ffff && !is_surrogate) {
        append_utf8(out, code);
      } else {
        bad_escapes.push_back(static_cast<std::uint32_t>(begin));
      }
      if (close != std::string_view::npos) i = close;
    } else {
      bad_escapes.push_back(static_cast<std::uint32_t>(begin));
    }
  }
  return out;
}

std::string write_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::uint32_t read_color(std::string_view digits) {
  std::uint32_t color = 0;
  for (const char c : digits) {
    const auto value = static_cast<std::uint32_t>(hex_value(c));
    color = digits.size() == 3 ? color << 8 | value * 0x11 : color << 4 | value;
  }
  return color;
}

} // namespace rt::lang
