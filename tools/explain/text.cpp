#include "tools/explain/text.hpp"

#include "lang/text/utf8.hpp"
#include "tools/explain/naming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::tools::explain {
namespace {

constexpr int columns = 100;
constexpr int deepest_indent = 50; // beyond it there would be no room on a line

int width_of(std::string_view text) {
  int width = 0;
  for (std::size_t i = 0; i < text.size();) {
    const lang::Character c = lang::decode(text.substr(i));
    width += lang::display_width(c.code_point);
    i += c.bytes;
  }
  return width;
}

// Without a minus sign before a value rounded to 0.
std::string short_text(double v) {
  return fmt::format("{:.6g}", v + 0.0);
}

} // namespace

std::string number_text(double v) {
  if (std::isinf(v)) return v > 0 ? "∞" : "-∞";
  return fmt::format("{:.9g}", v + 0.0);
}

std::string vector_text(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", short_text(v.x), short_text(v.y), short_text(v.z));
}

std::string color_text(const Color& c) {
  if (c.r == c.g && c.g == c.b) return short_text(c.r);
  return fmt::format("({}, {}, {})", short_text(c.r), short_text(c.g), short_text(c.b));
}

std::string angle_text(double cosine) {
  return fmt::format("{:.2f}°", std::acos(std::clamp(cosine, -1.0, 1.0)) * (180 / std::numbers::pi));
}

std::string percent_text(double share) {
  const double percent = share * 100;
  if (percent > 99.5 && percent < 100) return "over 99 %";
  return percent >= 9.95 || percent == 0 ? fmt::format("{:.0f} %", percent) : fmt::format("{:.1f} %", percent);
}

std::string list_text(std::span<const std::string> items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

namespace {

// Up to the next space outside brackets: vectors and places are not split.
std::string_view next_word(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    if (text[i] == ' ' && depth <= 0) return text.substr(0, i);
  }
  return text;
}

} // namespace

void Page::line(int indent, std::string_view text, int hang) {
  const int margin = std::min(indent, deepest_indent);
  int column = margin;
  text_.append(static_cast<std::size_t>(margin), ' ');
  for (bool is_first = true; !text.empty(); is_first = false) {
    const std::string_view word = next_word(text);
    const int width = width_of(word);
    if (!is_first && column + 1 + width > columns) {
      while (text_.ends_with(' ')) text_.pop_back();
      text_ += '\n';
      column = margin + hang;
      text_.append(static_cast<std::size_t>(column), ' ');
    } else if (!is_first) {
      text_ += ' ';
      ++column;
    }
    text_ += word;
    column += width;
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  text_ += '\n';
}

} // namespace rt::tools::explain
