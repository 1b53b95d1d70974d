#include "lang/evaluate/expressions/formula_evaluator.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/values/builtin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rt::lang {
namespace {

Opcode arithmetic_operation(Op op) {
  switch (op) {
  case Op::add:
    return Opcode::add;
  case Op::subtract:
    return Opcode::subtract;
  case Op::multiply:
    return Opcode::multiply;
  case Op::divide:
    return Opcode::divide;
  case Op::modulo:
    return Opcode::modulo;
  default:
    return Opcode::power;
  }
}

std::optional<Value> comparison(const Formulas& formulas, Op op, const Value& left, const Value& right) {
  if (!is_number_like(left) || !is_number_like(right)) return std::nullopt;
  const Term a = formulas.number(left), b = formulas.number(right);
  const auto [operation, is_swapped] = op == Op::less         ? std::pair(Opcode::less, false)
                                       : op == Op::less_equal ? std::pair(Opcode::less_equal, false)
                                       : op == Op::greater    ? std::pair(Opcode::less, true)
                                                              : std::pair(Opcode::less_equal, true);
  return formulas.truth(is_swapped ? b.apply(operation, a) : a.apply(operation, b));
}

std::optional<Value> result_of(const Formulas& formulas, Op op, const Value& left, const Value& right) {
  switch (op) {
  case Op::equal:
    return formulas.equality(left, right);
  case Op::not_equal: {
    const auto is_equal = formulas.equality(left, right);
    return is_equal ? std::optional(formulas.truth(formulas.boolean(*is_equal).apply(Opcode::not_))) : std::nullopt;
  }
  case Op::less:
  case Op::less_equal:
  case Op::greater:
  case Op::greater_equal:
    return comparison(formulas, op, left, right);
  case Op::unite:
  case Op::intersect:
    return std::nullopt;
  default:
    return formulas.arithmetic(arithmetic_operation(op), left, right);
  }
}

// Whether a formula in it is of another function than this.
bool is_foreign(const Value& value, const FunctionBuilder* builder) {
  const auto is_one = [builder](const Value& part) { return is_foreign(part, builder); };
  if (value.is(ValueKind::list)) return std::ranges::any_of(value.items(), is_one);
  if (value.is(ValueKind::record))
    return std::ranges::any_of(value.record().entries, is_one, &Record::RecordEntry::value);
  return value.is(ValueKind::formula) && value.formula().builder.get() != builder;
}

} // namespace

bool FormulaEvaluator::is_of_this_point(std::span<const Value> values, Span place) {
  for (const Value& value : values)
    if (is_foreign(value, evaluation_.compiled))
      return refuse(errors::not_known_yet(place, "this depends on the point of another function",
                                          "a function within a function of a point has a point of its own"));
  return true;
}

// Every function that is compiled has an end.
Value FormulaEvaluator::kept(Value value, Span place) {
  limits_.spend(1, place);
  limits_.check_length(evaluation_.compiled->size(), place);
  return value;
}

Value FormulaEvaluator::binary(Op op, const Value& left, const Value& right, Span place) {
  const std::array values{left, right};
  if (!is_of_this_point(values, place)) return Value::poison();
  if (auto value = result_of(Formulas(heap_, values), op, left, right)) return kept(*std::move(value), place);
  return fail(errors::wrong_operand(
      place, fmt::format("`{}` cannot be applied to {} and {}", spelling(op), describe(left), describe(right))));
}

Value FormulaEvaluator::with_sign(Op op, const Value& value, Span place) {
  const std::array values{value};
  if (!is_of_this_point(values, place)) return Value::poison();
  const Formulas formulas(heap_, values);
  const std::size_t size = vector_like_size(value);
  if (!is_number_like(value) && size == 0)
    return fail(
        errors::wrong_operand(place, fmt::format("`{}` cannot be applied to {}", spelling(op), describe(value))));
  if (op == Op::plus) return value;
  if (size == 0) return kept(formulas.value(-formulas.number(value)), place);
  const TermVector v = formulas.vector(value);
  return kept(formulas.vector({-v[0], -v[1], -v[2]}, size), place);
}

Value FormulaEvaluator::negation(const Value& truth, Span place) {
  const std::array values{truth};
  if (!is_of_this_point(values, place)) return Value::poison();
  const Formulas formulas(heap_, values);
  return kept(formulas.truth(formulas.boolean(truth).apply(Opcode::not_)), place);
}

Value FormulaEvaluator::logic(Op op, const Value& left, const Value& right, Span place) {
  if (!is_boolean_like(right))
    return fail(errors::no_condition(place, "a condition must be true or false", "this is " + describe(right)));
  const std::array values{left, right};
  if (!is_of_this_point(values, place)) return Value::poison();
  const Formulas formulas(heap_, values);
  return kept(formulas.truth(
                  formulas.boolean(left).apply(op == Op::and_ ? Opcode::and_ : Opcode::or_, formulas.boolean(right))),
              place);
}

Value FormulaEvaluator::choice(const Value& condition, const Value& then, const Value& otherwise, Span place) {
  const std::array values{condition, then, otherwise};
  if (!is_of_this_point(values, place)) return Value::poison();
  if (auto value = Formulas(heap_, values).select(condition, then, otherwise)) return kept(*std::move(value), place);
  return fail(errors::not_known_yet(
      place,
      fmt::format("which branch this `if` takes depends on the point, and one gives {}, the other {}", describe(then),
                  describe(otherwise)),
      "both branches must give a number, a vector, a colour or a truth value"));
}

Value FormulaEvaluator::call(const Builtin& builtin, BuiltinCall& arguments, Span place) {
  if (!is_of_this_point(arguments.arguments, place)) return Value::poison();
  if (builtin.formula) return kept(builtin.formula(arguments), place);
  return fail(errors::not_known_yet(
      place, fmt::format("`{}` cannot be used with what depends on the point", builtin.name), "this depends on it"));
}

std::optional<Value> formula_member(const Value& value, std::string_view name) {
  const Formula& formula = value.formula();
  const std::string_view names = formula.type == FormulaType::vector  ? "xyz"
                                 : formula.type == FormulaType::color ? "rgb"
                                                                      : "";
  const std::size_t i = name.size() == 1 ? names.find(name) : std::string_view::npos;
  return i < formula.size ? std::optional(part_of(formula, i)) : std::nullopt;
}

} // namespace rt::lang
