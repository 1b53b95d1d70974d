#include "lang/evaluate/expressions/operators.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/values/properties.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::lang {
namespace {

Vec3 each(Op op, const Vec3& a, const Vec3& b) {
  return {Operators::compute(op, a.x, b.x), Operators::compute(op, a.y, b.y), Operators::compute(op, a.z, b.z)};
}

Value like(const Value& vector, const Vec3& v) {
  return vector.vector_size() == 2 ? Value::point(v.x, v.y) : Value(v);
}

} // namespace

bool is_solid_operator(Op op) {
  return op == Op::unite || op == Op::intersect || op == Op::subtract;
}

double Operators::compute(Op op, double a, double b) {
  switch (op) {
  case Op::add:
    return a + b;
  case Op::subtract:
    return a - b;
  case Op::multiply:
    return a * b;
  case Op::divide:
    return a / b;
  case Op::modulo:
    return a - b * std::floor(a / b);
  case Op::power:
    return std::pow(a, b);
  default:
    return 0;
  }
}

Value Operators::with_sign(Op op, const Value& value, Span place) {
  if (value.is_number()) return op == Op::plus ? value.number() : -value.number();
  if (value.is(ValueKind::vector)) return op == Op::plus ? value : like(value, -value.vector());
  if (value.is(ValueKind::formula)) return formulas_.with_sign(op, value, place);
  return fail(errors::wrong_operand(place, fmt::format("`{}` cannot be applied to {}", spelling(op), describe(value))));
}

Value Operators::binary(Op op, const Value& left, const Value& right, Span place) {
  if (evaluation_.compiled && (holds_formula(left) || holds_formula(right)))
    return formulas_.binary(op, left, right, place);
  switch (op) {
  case Op::equal:
    return Value::boolean(equal(left, right));
  case Op::not_equal:
    return Value::boolean(!equal(left, right));
  case Op::less:
  case Op::less_equal:
  case Op::greater:
  case Op::greater_equal:
    return comparison(op, left, right, place);
  default:
    return arithmetic(op, left, right, place);
  }
}

Value Operators::comparison(Op op, const Value& left, const Value& right, Span place) {
  const auto compare = [&](const auto& a, const auto& b) {
    return Value::boolean(op == Op::less ? a < b : op == Op::less_equal ? a <= b : op == Op::greater ? a > b : a >= b);
  };
  if (left.is_number() && right.is_number()) return compare(left.number(), right.number());
  if (left.is(ValueKind::string) && right.is(ValueKind::string)) return compare(left.text(), right.text());
  return fail(errors::wrong_operand(place, fmt::format("`{}` compares two numbers or two strings", spelling(op)),
                                    fmt::format("this is {} and {}", describe(left), describe(right))));
}

Value Operators::arithmetic(Op op, const Value& left, const Value& right, Span place) {
  if (op == Op::unite || op == Op::intersect) return wrong_operands(op, left, right, place);
  if (op == Op::add && left.is(ValueKind::string) && right.is(ValueKind::string)) {
    limits_.reserve(left.text().size() + right.text().size(), place);
    return make_string(heap_, left.text() + right.text());
  }
  const bool has_vector = left.is(ValueKind::vector) || right.is(ValueKind::vector);
  if (has_vector && (left.is_number() || left.is(ValueKind::vector)) &&
      (right.is_number() || right.is(ValueKind::vector)))
    return vector_arithmetic(op, left, right, place);
  const bool has_color = left.is(ValueKind::color) || right.is(ValueKind::color);
  const auto a = as_color(left), b = as_color(right);
  if (a && b &&
      (has_color || (!left.is_number() && !right.is_number()) || left.is(ValueKind::thing) ||
       right.is(ValueKind::thing)))
    return color_arithmetic(op, *a, *b, place);
  return wrong_operands(op, left, right, place);
}

Value Operators::vector_arithmetic(Op op, const Value& left, const Value& right, Span place) {
  const bool both = left.is(ValueKind::vector) && right.is(ValueKind::vector);
  if (both) {
    if (left.vector_size() != right.vector_size())
      return fail(errors::wrong_operand(place, fmt::format("`{}` needs two vectors of the same size", spelling(op)),
                                        fmt::format("{} and {} numbers", left.vector_size(), right.vector_size())));
    if (op != Op::power && op != Op::modulo) return like(left, each(op, left.vector(), right.vector()));
    return wrong_operands(op, left, right, place);
  }
  const bool may_scale = op == Op::multiply || (op == Op::divide && right.is_number());
  if (!may_scale) return wrong_operands(op, left, right, place);
  const Value& vector = left.is_number() ? right : left;
  const double number = left.is_number() ? left.number() : right.number();
  return like(vector, each(op, vector.vector(), {number, number, number}));
}

Value Operators::color_arithmetic(Op op, const Color& a, const Color& b, Span place) {
  if (op == Op::power || op == Op::modulo) return wrong_operands(op, Value(a), Value(b), place);
  return Color{compute(op, a.r, b.r), compute(op, a.g, b.g), compute(op, a.b, b.b)};
}

Value Operators::wrong_operands(Op op, const Value& left, const Value& right, Span place) {
  std::string advice;
  if (op == Op::add && (left.is(ValueKind::string) || right.is(ValueKind::string)))
    advice = "`str(x)` turns a value into text";
  if (op == Op::add && is_sequence(left) && is_sequence(right)) advice = "`concat(a, b)` joins two lists";
  if ((op == Op::add || op == Op::subtract) && (left.is_number() || right.is_number()) &&
      (left.is(ValueKind::vector) || right.is(ValueKind::vector)))
    advice = "a vector and a number cannot be added: write `[x, y, z]` for both";
  if (op == Op::add && left.is(ValueKind::thing)) advice = "`a | b` is the union of two solids";
  if (is_solid_operator(op) && (left.is(ValueKind::thing) || right.is(ValueKind::thing)))
    advice = "solids are combined with solids";
  return fail(errors::wrong_operand(
      place, fmt::format("`{}` cannot be applied to {} and {}", spelling(op), describe(left), describe(right)), {},
      std::move(advice)));
}

} // namespace rt::lang
