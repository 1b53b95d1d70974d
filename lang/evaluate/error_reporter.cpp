#include "lang/evaluate/error_reporter.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace rt::lang {
namespace {

constexpr std::size_t calls_shown_at_each_end = 3;

} // namespace

Value ErrorReporter::fail(Diagnostic error) {
  // If a line may never run, only what is wrong regardless of values is reported.
  if (unsure_ > 0 && errors::depends_on_values(error)) return Value::poison();
  Diagnostic* d = report_.add(std::move(error));
  if (!d) return Value::poison();
  if (compilations_ > 0)
    d->notes.push_back({std::nullopt, "this function is compiled for all points at once: what depends on the point is "
                                      "known only while the picture is made, and of an `if` that depends on it both "
                                      "branches are followed"});
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
  return Value::poison();
}

void ErrorReporter::print(std::string text, Span place) {
  if (unsure_ == 0) printed_.push_back(errors::printed(report_.place(place), std::move(text)));
}

} // namespace rt::lang
