#include "lang/evaluate/limit_guard.hpp"

#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "renderer/functions/function.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

constexpr std::uint64_t steps_between_looks = 1'024;

std::string amount(std::uint64_t bytes) {
  return bytes >= std::uint64_t{1} << 20 ? fmt::format("{} MiB", bytes >> 20) : fmt::format("{} bytes", bytes);
}

} // namespace

void LimitGuard::end(Diagnostic error) {
  errors_.fail(std::move(error));
  throw Ended{};
}

void LimitGuard::give_up(Diagnostic error) {
  errors_.fail(std::move(error));
  throw TooDeep{};
}

void LimitGuard::restart(const char* stack_limit) {
  stack_limit_ = stack_limit;
  steps_ = next_look_ = objects_ = 0;
}

void LimitGuard::spend_if_too_many(double count, Span place) {
  const std::uint64_t left = limits_.steps - std::min(limits_.steps, steps_);
  if (count > static_cast<double>(left)) spend(limits_.steps, place);
}

void LimitGuard::look(Span place) {
  if (steps_ > limits_.steps)
    end(errors::too_many_steps(place, fmt::format("this scene takes more than {} steps", limits_.steps),
                               "here it was stopped; `--max-steps` allows more"));
  if (stop_ && stop_->load(std::memory_order_relaxed))
    end(errors::stopped(place, "stopped", "evaluation had come to here"));
  reserve(0, place);
  next_look_ = std::min(steps_ + steps_between_looks, limits_.steps + 1);
}

std::uint64_t LimitGuard::bytes_in_use() const {
  std::uint64_t shapes = 0;
  scene::ShapeKinds::for_each([&]<class S>() { shapes += scene_.shapes.all<S>().capacity() * sizeof(S); });
  return heap_.bytes() + shapes + objects_ * sizeof(scene::Object) +
         scene_.materials.capacity() * sizeof(scene::Material) +
         scene_.transforms.capacity() * sizeof(scene::Placement);
}

void LimitGuard::reserve(std::uint64_t bytes, Span place) {
  if (bytes_in_use() + bytes <= limits_.memory_bytes) return;
  end(errors::too_much_memory(place,
                              fmt::format("this scene takes more than {} of memory", amount(limits_.memory_bytes)),
                              "here it was stopped; `--max-memory` allows more"));
}

void LimitGuard::count_objects(std::size_t count, Span place) {
  objects_ += count;
  if (objects_ <= limits_.objects) return;
  end(errors::too_many_objects(place, fmt::format("this scene has more than {} objects", limits_.objects),
                               "here it was stopped; `--max-objects` allows more"));
}

void LimitGuard::check_depth(std::uint16_t depth, Span place) {
  if (depth <= most_depth) return;
  give_up(errors::too_deep(place, fmt::format("things or lists are nested more than {} deep", most_depth),
                           "here it was stopped"));
}

void LimitGuard::check_length(std::size_t instructions, Span place) {
  if (instructions <= rt::Function::most_instructions) return;
  give_up(errors::function_too_long(
      place, fmt::format("this function becomes more than {} instructions", rt::Function::most_instructions),
      "here it was stopped", "loops and calls that it is made of are written out, one turn after the other"));
}

void LimitGuard::enter_call(Span place) {
  spend(1, place);
  const char here = 0;
  const int depth = recursion_ + 1;
  if (depth > limits_.recursion)
    give_up(errors::calls_too_deep(place, fmt::format("calls are nested more than {} deep", limits_.recursion),
                                   "infinite recursion?"));
  if (&here < stack_limit_)
    give_up(errors::calls_too_deep(place, fmt::format("calls are nested too deeply: {} of them fill the stack", depth),
                                   "here it was stopped"));
  recursion_ = depth;
}

} // namespace rt::lang
