#include "tools/import/import.hpp"

#include "tools/import/mini_rt.hpp"

#include <algorithm>

namespace rt::tools::import {

bool Imported::has_errors() const {
  return std::ranges::any_of(diagnostics, [](const auto& d) { return d.severity == lang::Severity::error; });
}

std::span<const Format> formats() {
  static constexpr Format table[] = {{"miniRT", ".rt", read_mini_rt}};
  return table;
}

const Format* format_of(std::string_view path) {
  const auto found = std::ranges::find_if(formats(), [&](const Format& f) { return path.ends_with(f.extension); });
  return found == formats().end() ? nullptr : &*found;
}

} // namespace rt::tools::import
