#include "tools/terminal/wrap.hpp"

#include "lang/text/utf8.hpp"

#include <algorithm>

namespace rt::tools {
namespace {

std::size_t indent_of_rest(std::string_view line) {
  const std::size_t first = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.find("  ", first);
  const std::size_t second = gap == std::string_view::npos ? gap : line.find_first_not_of(' ', gap);
  return second == std::string_view::npos ? first + 2 : second;
}

// How many bytes of the line fit: up to a space, or the whole first word.
std::size_t fitting(std::string_view line, std::size_t columns, std::size_t least) {
  std::size_t fits = std::string_view::npos;
  for (std::size_t space = line.find(' ', least); space != std::string_view::npos; space = line.find(' ', space + 1)) {
    if (fits != std::string_view::npos && lang::display_width(line.substr(0, space)) > columns) break;
    fits = space;
  }
  return fits == std::string_view::npos ? line.size() : fits;
}

} // namespace

std::string wrapped(std::string_view text, std::size_t columns) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    const std::size_t indent = indent_of_rest(line);
    while (lang::display_width(line) > columns && indent < columns) {
      const std::size_t cut = fitting(line, columns, indent);
      if (cut == line.size()) break;
      out += line.substr(0, cut) + "\n";
      line = std::string(indent, ' ') + line.substr(cut + 1);
    }
    out += line;
    if (end < text.size()) out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

} // namespace rt::tools
