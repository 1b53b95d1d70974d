#include "lang/evaluate/error_reporter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

constexpr std::size_t calls_shown_at_each_end = 3;

} // namespace

Diagnostic* ErrorReporter::error(std::string_view code, Span place) {
  // Where it is not sure that a line runs at all, only what is wrong whatever the values are counts.
  constexpr std::string_view about_values[] = {"E0302", "E0303", "E0308", "E0310", "E0311", "E0312", "E0406", "E0407"};
  if (unsure_ > 0 && std::ranges::find(about_values, code) != std::end(about_values)) return nullptr;
  Diagnostic* d = report_.error(code, place);
  if (!d) return nullptr;
  std::vector<const CallFrame*> calls;
  for (const CallFrame* call = calls_; call; call = call->caller) calls.push_back(call);
  for (std::size_t i = 0; i < calls.size(); ++i) {
    const bool is_in_the_middle = i >= calls_shown_at_each_end && i + calls_shown_at_each_end < calls.size();
    if (is_in_the_middle && i > calls_shown_at_each_end) continue;
    if (is_in_the_middle) {
      d->call_stack.push_back(
          {std::nullopt, fmt::format("… {} more calls", calls.size() - 2 * calls_shown_at_each_end)});
      continue;
    }
    const FunctionInfo& function = *calls[i]->function;
    const std::string what = function.name == no_symbol ? "a function" : fmt::format("`{}`", name(function.name));
    d->call_stack.push_back({report_.place(calls[i]->place),
                             fmt::format("in {}, {} here", what, function.kind == Kind::def ? "made" : "called")});
  }
  return d;
}

Value ErrorReporter::fail(std::string_view code, Span place, std::string message, std::string label,
                          std::string advice) {
  if (Diagnostic* d = error(code, place)) {
    d->message = std::move(message);
    d->label = std::move(label);
    if (!advice.empty()) d->notes.push_back({std::nullopt, std::move(advice)});
  }
  return Value::poison();
}

void ErrorReporter::tell(const Mistake& mistake, Span place) {
  if (Diagnostic* d = error(mistake.code, place)) {
    d->message = mistake.message;
    d->label = mistake.label;
    for (const std::string& line : mistake.advice) d->notes.push_back({std::nullopt, line});
  }
}

} // namespace rt::lang
