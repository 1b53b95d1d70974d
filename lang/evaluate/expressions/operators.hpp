#pragma once

#include "lang/evaluate/expressions/formula_evaluator.hpp"

namespace rt::lang {

/// The operators on values: arithmetic and comparison, but not `and`, `or` and the combination of solids.
class Operators : private EvaluationPart {
public:
  explicit Operators(Evaluation& evaluation) : EvaluationPart(evaluation), formulas_(evaluation) {}

  /// `-x` or `+x`.
  Value with_sign(Op op, const Value& value, Span place);
  /// Neither is poison.
  Value binary(Op op, const Value& left, const Value& right, Span place);
  static double compute(Op op, double left, double right);

private:
  Value comparison(Op op, const Value& left, const Value& right, Span place);
  Value arithmetic(Op op, const Value& left, const Value& right, Span place);
  Value vector_arithmetic(Op op, const Value& left, const Value& right, Span place);
  Value color_arithmetic(Op op, const Color& left, const Color& right, Span place);
  Value wrong_operands(Op op, const Value& left, const Value& right, Span place);

  FormulaEvaluator formulas_;
};

/// Whether the operator combines solids if both sides are things.
bool is_solid_operator(Op op);

} // namespace rt::lang
