#include "lang/syntax/repeat_text.hpp"

#include "lang/text/characters.hpp"
#include "lang/text/literals.hpp"

#include <algorithm>
#include <cmath>

namespace rt::lang {

namespace {

constexpr std::string_view before_number = "[,:", after_number = "],};";
// What may contain digits that are not numbers, or numbers written in different ways.
constexpr std::string_view doubtful = "\"'#/()";

bool is_one_of(std::string_view set, char c) {
  return set.find(c) != std::string_view::npos;
}

// Whether what ends at `at` is certainly complete: it is before one of these marks, or before a line's end if the next
// line does not begin with a dot, a brace or a comment.
bool ends(std::string_view text, std::size_t at, std::string_view marks) {
  while (at < text.size() && is_blank(text[at])) ++at;
  if (at >= text.size() || text[at] != '\n') return at >= text.size() || is_one_of(marks, text[at]);
  while (at < text.size() && (is_blank(text[at]) || text[at] == '\n')) ++at;
  return at >= text.size() || !is_one_of(".{/#", text[at]);
}

bool is_same(double a, double b) {
  return a == b && std::signbit(a) == std::signbit(b);
}

} // namespace

std::optional<RepeatText> RepeatText::of(std::string_view item, std::span<const double> literals) {
  if (item.find_first_of(doubtful) != std::string_view::npos) return std::nullopt;
  RepeatText repeat_text;
  std::uint32_t begin = 0; // of the piece
  char last = '\0';        // the last one that is not blank
  for (std::uint32_t at = 0; at < item.size();) {
    const char c = item[at];
    if (is_name_start(c)) {
      while (at < item.size() && is_name_part(item[at])) ++at;
    } else if (begins_number(item.substr(at)) || (is_sign(c) && is_one_of(before_number, last))) {
      const NumberLiteral literal = read_signed_number(item.substr(at));
      const std::uint32_t end = at + literal.length;
      const std::size_t number = repeat_text.pieces_.size();
      if (!is_one_of(before_number, last) || literal.length == 0 || !ends(item, end, after_number) ||
          number == literals.size() || !is_same(literals[number], literal.value))
        return std::nullopt;
      repeat_text.pieces_.push_back(item.substr(begin, at - begin));
      begin = at = end;
    } else {
      ++at;
    }
    if (!is_blank(item[at - 1])) last = item[at - 1];
  }
  if (repeat_text.pieces_.size() != literals.size() || last != '}') return std::nullopt;
  repeat_text.pieces_.push_back(item.substr(begin));
  return repeat_text;
}

bool RepeatText::agrees(const RepeatText& other, std::size_t first, std::size_t last) const {
  const auto begin = [&](const RepeatText& w) { return w.pieces_.begin() + static_cast<std::ptrdiff_t>(first); };
  return pieces_.size() >= last && other.pieces_.size() >= last &&
         std::equal(begin(*this), pieces_.begin() + static_cast<std::ptrdiff_t>(last), begin(other));
}

bool ends_item(std::string_view text, std::uint32_t at) {
  return ends(text, at, ",;}");
}

} // namespace rt::lang
