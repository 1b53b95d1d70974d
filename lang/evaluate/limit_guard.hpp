#pragma once

#include "lang/evaluate/error_reporter.hpp"
#include "lang/evaluate/limits.hpp"
#include "renderer/scene/scene.hpp"

#include <atomic>
#include <cstdint>

namespace rt::lang {

/// Keeps an evaluation within its limits: steps, objects, memory, and the nesting depth of calls and things. Exceeding
/// one is reported, and ends the evaluation by an exception.
class LimitGuard {
public:
  /// A limit was exceeded, or the evaluation was stopped from outside; either is reported.
  struct Ended {};
  /// Calls or things are nested too deeply: only one item of a file is abandoned.
  struct TooDeep : Ended {};

  /// `heap` and `scene` are those whose memory counts. `stack_limit` is the lowest address that the stack may reach.
  LimitGuard(ErrorReporter& errors, const Limits& limits, const std::atomic<bool>* stop, const char* stack_limit,
             const Heap& heap, const scene::Scene& scene)
      : errors_(errors), limits_(limits), stop_(stop), stack_limit_(stack_limit), heap_(heap), scene_(scene) {}
  /// Counts from 0 again.
  void restart(const char* stack_limit);

  void spend(std::uint64_t steps, Span place) {
    steps_ += steps;
    if (steps_ >= next_look_) look(place);
  }
  std::uint64_t steps() const { return steps_; }
  /// Spends `count` steps at once if fewer are left, so that they need not be counted one by one.
  void spend_if_too_many(double count, Span place);
  void reserve(std::uint64_t bytes, Span place);
  void count_objects(std::size_t count, Span place);
  void check_depth(std::uint16_t depth, Span place);
  /// Of a function that is being compiled: how many instructions it has.
  void check_length(std::size_t instructions, Span place);

  /// During its lifetime, calls are nested one level deeper.
  class NestedCall {
  public:
    NestedCall(LimitGuard& guard, Span place) : guard_(guard) { guard_.enter_call(place); }
    NestedCall(const NestedCall&) = delete;
    NestedCall& operator=(const NestedCall&) = delete;
    ~NestedCall() { --guard_.recursion_; }

  private:
    LimitGuard& guard_;
  };

private:
  void look(Span place);
  void enter_call(Span place);
  std::uint64_t bytes_in_use() const;
  [[noreturn]] void end(Diagnostic error);
  [[noreturn]] void give_up(Diagnostic error);

  static constexpr std::uint16_t most_depth = 1'000;

  ErrorReporter& errors_;
  const Limits& limits_;
  const std::atomic<bool>* stop_;
  const char* stack_limit_;
  const Heap& heap_;
  const scene::Scene& scene_;
  std::uint64_t steps_ = 0;
  std::uint64_t next_look_ = 0;
  std::uint64_t objects_ = 0;
  int recursion_ = 0;
};

} // namespace rt::lang
