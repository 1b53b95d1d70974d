#include "lang/diagnostics/codes/groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace rt::lang {

namespace {

// Wraps a paragraph to fit a terminal.
std::string wrapped(std::string_view text) {
  constexpr std::size_t width = 80;
  std::string out;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    if (column > 0 && column + 1 + end > width) {
      out += '\n';
      column = 0;
    }
    if (column > 0) out += ' ';
    out += text.substr(0, end);
    column += end + (column > 0 ? 1 : 0);
    if (end < text.size() && text[end] == '\n') {
      out += '\n';
      column = 0;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

} // namespace

std::vector<Code> all_codes() {
  std::vector<Code> all;
  for (const auto& group : {codes::syntax(), codes::names(), codes::values(), codes::things(), codes::limits(),
                            codes::files(), codes::expectations(), codes::imports(), codes::lint(), codes::remarks()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

std::optional<Code> find_code(std::string_view code) {
  for (const Code& entry : all_codes()) {
    if (entry.code == code) return entry;
  }
  return std::nullopt;
}

std::string explain(const Code& code) {
  std::string text = fmt::format("{}: {}\n\n{}\n", code.code, code.title, wrapped(code.meaning));
  const auto append = [&](std::string_view heading, std::string_view scene) {
    if (scene.empty()) return;
    text += fmt::format("\n{}\n\n", heading);
    while (!scene.empty()) {
      const std::size_t end = std::min(scene.find('\n'), scene.size());
      text += fmt::format("{}{}\n", end == 0 ? "" : "    ", scene.substr(0, end));
      scene.remove_prefix(std::min(end + 1, scene.size()));
    }
  };
  append("Example that causes it:", code.example);
  append("Fixed:", code.mended);
  return text;
}

} // namespace rt::lang
