#include "lang/evaluate/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

constexpr std::uint64_t steps_between_looks = 1'024;
constexpr std::size_t calls_shown_at_each_end = 3;

std::string amount(std::uint64_t bytes) {
  return bytes >= std::uint64_t{1} << 20 ? fmt::format("{} MiB", bytes >> 20) : fmt::format("{} bytes", bytes);
}

} // namespace

void Evaluator::end(std::string_view code, std::string message, std::string label, Span place) {
  fail(code, place, std::move(message), std::move(label));
  throw Ended{};
}

void Evaluator::give_up(std::string_view code, std::string message, std::string label, Span place) {
  fail(code, place, std::move(message), std::move(label));
  throw TooDeep{};
}

void Evaluator::look_at_limits(Span place) {
  if (steps_ > limits_.steps)
    end("E0501", fmt::format("this scene takes more than {} steps", limits_.steps),
        "here it was stopped; `--max-steps` allows more", place);
  if (stop_ && stop_->load(std::memory_order_relaxed)) end("E0505", "stopped", "evaluation had come to here", place);
  reserve(0, place);
  next_look_ = std::min(steps_ + steps_between_looks, limits_.steps + 1);
}

std::uint64_t Evaluator::bytes_in_use() const {
  std::uint64_t shapes = 0;
  scene::ShapeKinds::for_each([&]<class S>() { shapes += scene_.shapes.all<S>().capacity() * sizeof(S); });
  return heap_.bytes() + shapes + objects_ * sizeof(scene::Object) +
         scene_.materials.capacity() * sizeof(scene::Material) +
         scene_.transforms.capacity() * sizeof(scene::Placement);
}

void Evaluator::reserve(std::uint64_t bytes, Span place) {
  if (bytes_in_use() + bytes <= limits_.memory_bytes) return;
  end("E0504", fmt::format("this scene takes more than {} of memory", amount(limits_.memory_bytes)),
      "here it was stopped; `--max-memory` allows more", place);
}

void Evaluator::count_objects(std::size_t count, Span place) {
  objects_ += count;
  if (objects_ <= limits_.objects) return;
  end("E0503", fmt::format("this scene has more than {} objects", limits_.objects),
      "here it was stopped; `--max-objects` allows more", place);
}

void Evaluator::check_depth(std::uint16_t depth, Span place) {
  if (depth <= most_depth) return;
  give_up("E0506", fmt::format("things or lists are nested more than {} deep", most_depth), "here it was stopped",
          place);
}

void Evaluator::enter_call(Span place) {
  spend(1, place);
  const char here = 0;
  if (++recursion_ > limits_.recursion)
    give_up("E0502", fmt::format("calls are nested more than {} deep", limits_.recursion),
            "does this call itself without end?", place);
  if (&here < stack_limit_)
    give_up("E0502", fmt::format("calls are nested too deep: {} of them fill the stack", recursion_),
            "here it was stopped", place);
}

Diagnostic* Evaluator::error(std::string_view code, Span place) {
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

Value Evaluator::fail(std::string_view code, Span place, std::string message, std::string label, std::string advice) {
  if (Diagnostic* d = error(code, place)) {
    d->message = std::move(message);
    d->label = std::move(label);
    if (!advice.empty()) d->notes.push_back({std::nullopt, std::move(advice)});
  }
  return Value::poison();
}

void Evaluator::tell(const Mistake& mistake, Span place) {
  if (Diagnostic* d = error(mistake.code, place)) {
    d->message = mistake.message;
    d->label = mistake.label;
    for (const std::string& line : mistake.advice) d->notes.push_back({std::nullopt, line});
  }
}

} // namespace rt::lang
