#include "tools/import/import.hpp"

#include "tools/import/mini_rt.hpp"

#include <algorithm>

namespace rt::tools::import {

bool Imported::has_errors() const {
  return std::ranges::any_of(diagnostics, [](const auto& d) { return d.severity == lang::Severity::error; });
}

const Format* format_of(std::string_view path) {
  static constexpr Format formats[] = {{"miniRT", ".rt", read_mini_rt}};
  const auto* const found = std::ranges::find_if(formats, [&](const Format& f) { return path.ends_with(f.extension); });
  return found == std::end(formats) ? nullptr : found;
}

} // namespace rt::tools::import
