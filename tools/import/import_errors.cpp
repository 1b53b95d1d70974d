#include "tools/import/import_errors.hpp"

#include <utility>

namespace rt::tools::import::errors {

using lang::Diagnostic;
using lang::Note;
using lang::Span;

namespace {

std::vector<Note> advice_note(std::string advice) {
  if (advice.empty()) return {};
  return {{std::nullopt, std::move(advice)}};
}

} // namespace

Diagnostic malformed_line(Span place, std::string message, std::string label, std::string advice) {
  return lang::make_error("E0801", place, std::move(message), std::move(label), advice_note(std::move(advice)));
}

Diagnostic unknown_element(Span place, std::string message, std::string advice) {
  return lang::make_error("E0802", place, std::move(message), {}, advice_note(std::move(advice)));
}

Diagnostic wrong_count(Span place, std::string message, std::vector<Note> others) {
  return lang::make_error("E0803", place, std::move(message), {}, std::move(others));
}

Diagnostic taken_otherwise(Span place, std::string message, std::string label) {
  Diagnostic warning = lang::make_error("N0801", place, std::move(message), std::move(label));
  warning.severity = lang::Severity::warning;
  return warning;
}

} // namespace rt::tools::import::errors
