#pragma once

#include "lang/builtins/builtins.hpp"
#include "lang/evaluate/evaluation.hpp"
#include "lang/evaluate/expressions/call_evaluator.hpp"
#include "lang/evaluate/expressions/operators.hpp"

#include <span>
#include <string>
#include <vector>

namespace rt::lang {

/// What expressions need of the parts that make things and read files. They know nothing else about them.
class ThingSource {
public:
  /// A thing or a record with the changes of a block.
  virtual Value override_value(NodeId node, const Context& context) = 0;
  /// Two solids, or lists of them, combined.
  virtual Value combine(Op op, Value left, Value right, NodeId node, const Context& context) = 0;
  /// A copy with one more step in its chain.
  virtual Value moved(const Thing& thing, scene::Step step, Span place) = 0;
  /// The value of a `use` or a `param`.
  virtual Value declared_value(NodeId item, const Context& context) = 0;
  /// The observer of the scene, or of a thing alone; null after an error.
  virtual const Observer* observer() = 0;
  virtual std::optional<double> precision() const = 0;
  virtual const Observer* observer_of(const Value& thing, Span place) = 0;

protected:
  ~ThingSource() = default;
};

/// Evaluates expressions to values.
class ExpressionEvaluator : private EvaluationPart {
public:
  ExpressionEvaluator(Evaluation& evaluation, ThingSource& things)
      : EvaluationPart(evaluation), things_(things), operators_(evaluation), calls_(evaluation, *this, things),
        formulas_(evaluation) {}

  Value evaluate(NodeId node, const Context& context);
  /// Of a condition. False where it is in error, and then `is_poison`.
  bool is_true(NodeId condition, const Context& context, bool& is_poison) {
    return truth_of(evaluate(condition, context), condition, context, is_poison);
  }
  /// Gives the name that an item binds its value.
  void declare(NodeId item, const Context& context);
  Value member_of(const Value& base, NodeId node, const Context& context);
  Value function_value(const FunctionInfo& function, Frame* frame, Span place);
  /// Calls body(context) for each element of the head of a `for`, with its variables set.
  template <class Body>
  void for_each(NodeId node, const Context& context, Body&& body);
  Value call_function(const Value& function, std::vector<Value> arguments, Span place) {
    return calls_.call_function(function, std::move(arguments), place);
  }
  /// Gives the parameters that were not passed their defaults; false after a mistake.
  bool fill_defaults(const FunctionInfo& function, Frame& frame, Span place) {
    return calls_.fill_defaults(function, frame, place);
  }

private:
  bool truth_of(const Value& value, NodeId condition, const Context& context, bool& is_poison);
  Value name_value(NodeId node, const Context& context);
  Value list_value(NodeId node, const Context& context);
  Value record_value(NodeId node, const Context& context);
  Value comprehension_value(NodeId node, const Context& context);
  void comprehend(const Comprehension& parts, std::size_t clause, const Context& context, std::vector<Value>& items,
                  Charge& memory);
  Value index_value(NodeId node, const Context& context);
  Value member_value(NodeId node, const Context& context);
  Value thing_member(const Thing& thing, NodeId node, const Context& context);
  Value unknown_member(std::string message, std::string_view word, Span place, std::span<const std::string_view> names);
  Value range_value(NodeId node, const Context& context);
  Value if_value(NodeId node, const Context& context);
  Value choice_value(const Value& condition, NodeId node, const Context& context);
  Value value_block(NodeId block, const Context& context);
  Value unary_value(NodeId node, const Context& context);
  Value binary_value(NodeId node, const Context& context);
  Value logic_value(NodeId node, const Context& context);
  bool is_loop_head(const Value& head, NodeId node, const Context& context);

  ThingSource& things_;
  Operators operators_;
  CallEvaluator calls_;
  FormulaEvaluator formulas_;
};

template <class Body>
void ExpressionEvaluator::for_each(NodeId node, const Context& context, Body&& body) {
  const ForItem loop = context.ast().for_item(node);
  const std::uint32_t own_frame = context.ast()[node].extra;
  const Value head = evaluate(loop.head, context);
  const auto turn = [&](double i, Value element) {
    const auto run = [&](const Context& inner) {
      const Ast& ast = inner.ast();
      if (loop.index_name != no_node) (*inner.frame)[ast.slot(loop.index_name)] = i;
      (*inner.frame)[ast.slot(loop.value_name)] = std::move(element);
      body(inner);
    };
    if (own_frame == 0) return run(context);
    const FrameScope frame(evaluation_.frames, make_frame(heap_, Ref<Frame>(context.frame), own_frame));
    run({context.unit, frame.get()});
  };
  if (!is_loop_head(head, loop.head, context)) { // once, to find the errors in it
    const ErrorReporter::Unsure unsure(errors_);
    return turn(0, Value::poison());
  }
  const std::size_t size = sequence_size(head);
  for (std::size_t i = 0; i < size; ++i) turn(static_cast<double>(i), sequence_at(head, i));
}

} // namespace rt::lang
