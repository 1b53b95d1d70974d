#include "tools/repl/line_layout.hpp"

#include "lang/text/utf8.hpp"

#include <algorithm>

namespace rt::tools {

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const lang::Character c = lang::decode(text);
    if (c.code_point == '\n' || !lang::is_control(c.code_point)) out += text.substr(0, c.bytes);
    text.remove_prefix(c.bytes);
  }
  return out;
}

int rows_above(std::string_view text, int column, int columns) {
  int rows = 0;
  const auto next_row = [&] { ++rows, column = 0; };
  while (!text.empty()) {
    const lang::Character c = lang::decode(text);
    text.remove_prefix(c.bytes);
    if (c.code_point == '\n') {
      next_row();
      continue;
    }
    const int width = lang::display_width(c.code_point);
    if (column + width > columns) next_row();
    column += width;
    if (column == columns) next_row(); // where the next character will be
  }
  return rows;
}

std::string indentation_after(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\')
        ++i;
      else if (c == '"' || c == '\n')
        in_string = false;
    } else if (c == '"')
      in_string = true;
    else if (c == '/' && text.substr(i, 2) == "//")
      i = std::min(text.find('\n', i), text.size());
    else if (c == '{' || c == '[' || c == '(')
      ++depth;
    else if (c == '}' || c == ']' || c == ')')
      depth = std::max(0, depth - 1);
  }
  return std::string(static_cast<std::size_t>(depth) * 2, ' ');
}

std::string in_columns(const std::vector<std::string>& words, std::size_t width) {
  std::size_t longest = 0;
  for (const std::string& word : words) longest = std::max(longest, word.size());
  const std::size_t columns = std::max<std::size_t>(1, width / (longest + 2));
  const std::size_t rows = (words.size() + columns - 1) / columns;
  std::string out;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = row; i < words.size(); i += rows) {
      out += words[i];
      if (i + rows < words.size()) out += std::string(longest + 2 - words[i].size(), ' ');
    }
    out += '\n';
  }
  return out;
}

} // namespace rt::tools
