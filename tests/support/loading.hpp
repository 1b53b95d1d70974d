#pragma once

#include "lang/load.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tests {

/// The text as a scene of its own, in a folder without other files, with everything that was said about it.
inline lang::Loaded load(std::string text, const lang::LoadOptions& options = {}) {
  return lang::load_text(std::move(text), "test.rtl", "no/such/folder", options);
}

/// The codes of the errors, in order; notes and warnings are left out.
inline std::vector<std::string> errors(const lang::Loaded& loaded) {
  std::vector<std::string> codes;
  for (const lang::Diagnostic& d : loaded.diagnostics) {
    if (d.severity == lang::Severity::error) codes.push_back(d.code);
  }
  return codes;
}

inline std::vector<std::string> errors(std::string text, const lang::LoadOptions& options = {}) {
  return errors(load(std::move(text), options));
}

/// Everything that was said, as it is shown: for the messages of failing tests.
inline std::string report(const lang::Loaded& loaded) {
  std::string text;
  for (const lang::Diagnostic& d : loaded.diagnostics) text += render(d, loaded.sources, false) + '\n';
  return text;
}

inline const lang::Diagnostic* find(const lang::Loaded& loaded, std::string_view code) {
  const auto found = std::ranges::find(loaded.diagnostics, code, &lang::Diagnostic::code);
  return found == loaded.diagnostics.end() ? nullptr : &*found;
}

/// The value of a number expression, by way of a sphere's radius. NaN where there is an error.
inline double number(const std::string& expression, const std::string& before = {}) {
  const lang::Loaded loaded = load(before + "\nsphere { at: [" + expression + ", 0, 0] }");
  return loaded.scene ? loaded.scene->objects.back().at.x : std::nan("");
}

} // namespace rt::tests
