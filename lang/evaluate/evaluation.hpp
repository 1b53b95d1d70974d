#pragma once

#include "lang/check/program.hpp"
#include "lang/evaluate/error_reporter.hpp"
#include "lang/evaluate/expressions/frames.hpp"
#include "lang/evaluate/limit_guard.hpp"
#include "lang/evaluate/things/description.hpp"
#include "renderer/functions/function_builder.hpp"

#include <string>
#include <utility>

namespace rt::lang {

/// Where an expression is evaluated: its text and the names in scope.
struct Context {
  Unit* unit;
  Frame* frame;
  Ast& ast() const { return unit->ast; }
};

/// What all parts of one evaluation share.
struct Evaluation {
  Evaluation(Program& the_program, Report& report, const Limits& the_limits, const std::atomic<bool>* stop,
             const char* stack_limit)
      : program(the_program), errors(report, the_program.symbols),
        limits(errors, the_limits, stop, stack_limit, heap, builder.scene) {}

  Program& program;
  Heap heap;
  scene::Builder builder;
  ErrorReporter errors;
  LimitGuard limits;
  Frames frames;
  FunctionBuilder* compiled = nullptr; ///< the function that is being compiled
  bool may_have_unused = false;        ///< shapes may have been made that stand nowhere
};

/// Base class of the parts: names for what they share.
class EvaluationPart {
public:
  EvaluationPart(const EvaluationPart&) = delete;
  EvaluationPart& operator=(const EvaluationPart&) = delete;

protected:
  explicit EvaluationPart(Evaluation& evaluation)
      : evaluation_(evaluation), program_(evaluation.program), heap_(evaluation.heap), errors_(evaluation.errors),
        limits_(evaluation.limits) {}
  ~EvaluationPart() = default;

  Value fail(Diagnostic error) { return errors_.fail(std::move(error)); }
  /// The same for functions that return whether something succeeded.
  bool refuse(Diagnostic error) { return fail(std::move(error)), false; }
  std::string_view name(Symbol symbol) const { return errors_.name(symbol); }

  Evaluation& evaluation_;
  Program& program_;
  Heap& heap_;
  ErrorReporter& errors_;
  LimitGuard& limits_;
};

/// A thing without properties, written at `place`.
inline Ref<Thing> make_thing(Heap& heap, const NodeType& type, Span place) {
  Ref<Thing> thing(heap.make<Thing>(0));
  thing->type = &type;
  thing->span = place;
  return thing;
}

} // namespace rt::lang
