#pragma once

#include "lang/builtins/builtins.hpp"
#include "lang/evaluate/expressions/formula_evaluator.hpp"

#include <vector>

namespace rt::lang {

class ExpressionEvaluator;
class ThingSource;

/// Calls functions: the program's, built-in ones, and chain methods.
class CallEvaluator : private EvaluationPart {
public:
  CallEvaluator(Evaluation& evaluation, ExpressionEvaluator& expressions, ThingSource& things)
      : EvaluationPart(evaluation), expressions_(expressions), things_(things), formulas_(evaluation) {}

  Value call_value(NodeId node, const Context& context);
  Value call_function(const Value& function, std::vector<Value> arguments, Span place);
  bool fill_defaults(const FunctionInfo& function, Frame& frame, Span place);

private:
  Value call(const Value& callee, NodeId node, const Context& context);
  Value call_closure(const FunctionInfo& function, Frame* parent, NodeId node, const Context& context);
  bool pass_arguments(const FunctionInfo& function, Frame& frame, NodeId node, const Context& context);
  Value run(const FunctionInfo& function, Frame& frame, Span place);
  Value call_builtin(const Builtin& builtin, NodeId node, const Context& context);
  Value run_builtin(const Builtin& builtin, BuiltinCall& arguments, Span place);
  Value call_builtin_with(const Builtin& builtin, std::vector<Value> values, Span place);
  Value call_chain(const Value& base, const ChainMethod& method, NodeId node, const Context& context);

  ExpressionEvaluator& expressions_;
  ThingSource& things_;
  FormulaEvaluator formulas_;
};

} // namespace rt::lang
