#pragma once

#include "lang/evaluate/evaluation.hpp"
#include "lang/values/formula.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace rt::lang {

/// What operators, conditions and built-in functions do where a value depends on the point: they become instructions of
/// the function that is being compiled.
class FormulaEvaluator : private EvaluationPart {
public:
  explicit FormulaEvaluator(Evaluation& evaluation) : EvaluationPart(evaluation) {}

  /// One of the values is a formula, or holds one.
  Value binary(Op op, const Value& left, const Value& right, Span place);
  /// `-x` or `+x`.
  Value with_sign(Op op, const Value& value, Span place);
  /// `not x`.
  Value negation(const Value& truth, Span place);
  /// `and`, `or` of a formula and what `right` is.
  Value logic(Op op, const Value& left, const Value& right, Span place);
  /// Of an `if` whose condition is a formula, both branches evaluated.
  Value choice(const Value& condition, const Value& then, const Value& otherwise, Span place);
  /// A call some of whose arguments depend on the point.
  Value call(const Builtin& builtin, BuiltinCall& arguments, Span place);

private:
  bool is_of_this_point(std::span<const Value> values, Span place);
  Value kept(Value value, Span place);
};

/// x, y, z of a vector that depends on the point, or r, g, b of a colour; nothing for any other name.
std::optional<Value> formula_member(const Value& formula, std::string_view name);

} // namespace rt::lang
