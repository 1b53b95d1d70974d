#include "lang/report.hpp"

#include <algorithm>

namespace rt::lang {

Diagnostic* Report::add(Severity severity, std::string_view code, Span span) {
  if (severity == Severity::error) ++errors_;
  if (is_full()) return nullptr;
  const auto overlaps = [&](const Span& other) {
    return other.file == span.file && other.begin < std::max(span.end, span.begin + 1) && span.begin < std::max(other.end, other.begin + 1);
  };
  if (severity == Severity::error && std::ranges::any_of(malformed_, overlaps)) return nullptr;
  if (!known_.emplace(span.file, span.begin, span.end, std::string(code)).second) return nullptr;
  Diagnostic& diagnostic = diagnostics_.emplace_back();
  diagnostic.severity = severity;
  diagnostic.code = code;
  diagnostic.span = span;
  return &diagnostic;
}

void Report::take(std::vector<Diagnostic> diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == Severity::error) {
      ++errors_;
      malformed_.push_back(diagnostic.span);
    }
    diagnostics_.push_back(std::move(diagnostic));
  }
}

std::vector<Diagnostic> Report::finish() {
  const auto place = [](const Diagnostic& d) { return std::tuple(d.span.file, d.span.begin, d.span.end); };
  std::ranges::stable_sort(diagnostics_, {}, place);
  return std::move(diagnostics_);
}

} // namespace rt::lang
