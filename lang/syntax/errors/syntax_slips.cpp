#include "lang/syntax/errors/syntax_errors.hpp"
#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::lang {

namespace {

// This language's equivalent of another language's operator.
std::string_view own_name(std::string_view op) {
  if (op == "&&") return "write `and`";
  if (op == "||") return "write `or`";
  if (op == "!") return "write `not`";
  if (op == "**") return "write `^`";
  if (op == "++") return "a name keeps its value";
  if (op == "...") return "write `..`, or `..<` to leave out the end";
  return "";
}

Diagnostic unknown_unit(Span span, std::string_view text, std::uint32_t digits) {
  const std::string_view suffix = text.substr(digits);
  const std::string_view number = text.substr(0, digits);
  static constexpr std::array<std::string_view, 3> units{"deg", "rad", "turn"};
  std::string label = fmt::format("lengths have no unit: write `{}`", number);
  if (const auto unit = nearest(suffix, units)) label = fmt::format("did you mean `{}{}`?", number, *unit);
  if (suffix == "f" || suffix == "d" || suffix == "u" || suffix == "l") label = fmt::format("write `{}`", number);
  return errors::unknown_unit({span.file, span.begin + digits, span.end}, fmt::format("there is no unit `{}`", suffix),
                              std::move(label));
}

} // namespace

Diagnostic misused_operator(Complaint complaint, Span op, std::string_view op_text, std::string_view left) {
  const bool is_short = left.size() <= 40 && left.find('\n') == std::string_view::npos;
  switch (complaint) {
  case Complaint::chained_comparison: {
    const std::size_t middle = left.find_last_of("<>=!");
    std::string label = "write `a < b and b < c`";
    if (is_short && middle != std::string_view::npos) {
      const std::size_t begin = std::min(left.find_first_not_of(" \t", middle + 1), left.size());
      label = fmt::format("write `{} and {} {} …`", left, left.substr(begin), op_text);
    }
    return errors::chained_operators(op, "comparisons do not chain", std::move(label));
  }
  case Complaint::chained_range:
    return errors::chained_operators(op, "ranges do not chain", "the step follows `by`: `0..10 by 2`");
  case Complaint::misplaced_not:
    return errors::loose_not(op, "`not` has lower precedence than the operator before it", "write `(not …)`");
  case Complaint::step_without_range:
    return errors::by_without_range(op, "`by` belongs to a range", "`0..10 by 2`");
  case Complaint::none:
    break;
  }
  return errors::unexpected(op, fmt::format("`{}` is not allowed here", op_text));
}

Diagnostic foreign_operator(Span op, std::string_view op_text) {
  if (op_text == "=") {
    return errors::assignment_in_expression(op, "`=` gives a name a value and cannot stand inside an expression",
                                            "`==` compares");
  }
  return errors::foreign_operator(op, fmt::format("there is no operator `{}`", op_text),
                                  std::string(own_name(op_text)));
}

std::optional<Diagnostic> malformed_number(Span span, std::string_view text, std::uint32_t digits, double value) {
  const std::string_view suffix = text.substr(digits);
  const bool has_base = text.size() >= 2 && text[0] == '0' && digits == 1 &&
                        std::string_view("xXbBoO").find(text[1]) != std::string_view::npos;
  if (has_base) {
    const int base = (text[1] | 0x20) == 'x' ? 16 : (text[1] | 0x20) == 'b' ? 2 : 8;
    const std::string digits_of_base(text.substr(2));
    char* end = nullptr;
    const auto decimal = std::strtoull(digits_of_base.c_str(), &end, base);
    std::string label = *end == '\0' && !digits_of_base.empty() ? fmt::format("write `{}`", decimal) : "";
    return errors::number_not_decimal(span, "numbers are written in decimal", std::move(label));
  }
  if (suffix.starts_with('_')) {
    std::string plain(text);
    std::erase(plain, '_');
    return errors::number_not_decimal(span, "a number cannot contain `_`", fmt::format("write `{}`", plain));
  }
  if (suffix == "e" || suffix == "E") {
    return errors::malformed_number(span, "digits must follow the exponent's `e`", "a thousand is `1e3`");
  }
  if (std::isinf(value))
    return errors::malformed_number(span, "this number is too large", "the largest is about 1.8e308");
  if (!suffix.empty() && degrees_per(suffix) == 0) return unknown_unit(span, text, digits);
  return std::nullopt;
}

Diagnostic malformed_color(Span span, std::string_view text) {
  const std::string_view digits = text.substr(1);
  const auto wrong = std::find_if_not(digits.begin(), digits.end(), is_hex_digit);
  if (wrong != digits.end()) {
    return errors::malformed_color(span, fmt::format("`{}` is not a hexadecimal digit", *wrong),
                                   "a colour is `#rgb` or `#rrggbb`");
  }
  return errors::malformed_color(span, fmt::format("a colour has 3 or 6 digits, this one has {}", digits.size()),
                                 "`#rgb` or `#rrggbb`");
}

Diagnostic bad_escape(Span string, std::string_view text, std::uint32_t offset) {
  const bool is_code_point = text.substr(offset + 1, 1) == "u";
  const std::size_t close = text.find('}', offset);
  std::uint32_t length = 2;
  if (is_code_point && close != std::string_view::npos) length = static_cast<std::uint32_t>(close + 1 - offset);
  while (offset + length < text.size() && (text[offset + length] & 0xc0) == 0x80) ++length; // the whole character
  const std::uint32_t begin = string.begin + offset;
  return errors::unknown_escape(
      {string.file, begin, begin + length}, is_code_point ? "this is not a character code" : "there is no such escape",
      is_code_point ? "`\\u{e9}` is é" : "the escapes are `\\n`, `\\t`, `\\\"`, `\\\\` and `\\u{…}`");
}

} // namespace rt::lang
