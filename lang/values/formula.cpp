#include "lang/values/formula.hpp"

#include "lang/values/properties.hpp"

#include <algorithm>
#include <vector>

namespace rt::lang {
namespace {

const Value* find_formula(std::span<const Value> values) {
  for (const Value& value : values) {
    if (value.is(ValueKind::formula)) return &value;
    if (!value.is(ValueKind::list)) continue;
    if (const Value* found = find_formula(value.items())) return found;
  }
  return nullptr;
}

bool is_product(Opcode operation) {
  return operation == Opcode::multiply || operation == Opcode::divide;
}
bool is_elementwise(Opcode operation) {
  return is_product(operation) || operation == Opcode::add || operation == Opcode::subtract;
}

bool is_color_like(const Value& value) {
  return is_formula(value, FormulaType::color) || value.is(ValueKind::color) ||
         (value.is(ValueKind::thing) && as_color(value));
}

TermVector each(Opcode operation, const TermVector& a, const TermVector& b) {
  return {a[0].apply(operation, b[0]), a[1].apply(operation, b[1]), a[2].apply(operation, b[2])};
}

} // namespace

bool is_number_like(const Value& value) {
  return value.is_number() || is_formula(value, FormulaType::number);
}

bool is_boolean_like(const Value& value) {
  return value.is(ValueKind::boolean) || is_formula(value, FormulaType::boolean);
}

std::size_t vector_like_size(const Value& value) {
  if (value.is(ValueKind::vector)) return value.vector_size();
  return is_formula(value, FormulaType::vector) ? value.formula().size : 0;
}

bool holds_formula(const Value& value) {
  if (value.is(ValueKind::list)) return holds_formula(value.items());
  if (value.is(ValueKind::record))
    return std::ranges::any_of(value.record().entries,
                               [](const Record::RecordEntry& entry) { return holds_formula(entry.value); });
  return value.is(ValueKind::formula);
}

bool holds_formula(std::span<const Value> values) {
  return std::ranges::any_of(values, [](const Value& value) { return holds_formula(value); });
}

Formulas::Formulas(Heap& heap, std::span<const Value> values)
    : heap_(heap), builder_(find_formula(values)->formula().builder) {}

Term Formulas::number(const Value& value) const {
  return value.is_number() ? constant(value.number()) : value.formula().term(0);
}

Term Formulas::boolean(const Value& value) const {
  return value.is(ValueKind::boolean) ? constant(value.truth() ? 1 : 0) : value.formula().term(0);
}

TermVector Formulas::vector(const Value& value) const {
  if (value.is(ValueKind::vector)) {
    const Vec3& v = value.vector();
    return {constant(v.x), constant(v.y), constant(v.z)};
  }
  const Formula& formula = value.formula();
  return {formula.term(0), formula.term(1), formula.size == 3 ? formula.term(2) : constant(0)};
}

std::optional<TermVector> Formulas::color(const Value& value) const {
  if (is_formula(value, FormulaType::number)) return TermVector{number(value), number(value), number(value)};
  if (is_formula(value, FormulaType::color)) return vector(value);
  const auto color = as_color(value);
  return color ? std::optional(TermVector{constant(color->r), constant(color->g), constant(color->b)}) : std::nullopt;
}

Value Formulas::make(FormulaType type, std::span<const Term> terms) const {
  std::array<double, 3> known{};
  bool is_known = true;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const auto constant = builder_->constant_value(terms[i].node());
    is_known = is_known && constant;
    known[i] = constant.value_or(0);
  }
  if (is_known && type == FormulaType::number) return known[0];
  if (is_known && type == FormulaType::boolean) return Value::boolean(known[0] != 0);
  if (is_known && type == FormulaType::color) return Color{known[0], known[1], known[2]};
  if (is_known) return terms.size() == 2 ? Value::point(known[0], known[1]) : Value(Vec3{known[0], known[1], known[2]});
  Ref<Formula> formula(heap_.make<Formula>(0));
  formula->builder = builder_;
  formula->type = type;
  formula->size = static_cast<std::uint8_t>(terms.size());
  for (std::size_t i = 0; i < terms.size(); ++i) formula->parts[i] = terms[i].node();
  return formula;
}

std::optional<Value> Formulas::arithmetic(Opcode operation, const Value& left, const Value& right) const {
  if (is_number_like(left) && is_number_like(right)) return value(number(left).apply(operation, number(right)));
  if (!is_elementwise(operation)) return std::nullopt;
  const std::size_t left_size = vector_like_size(left), right_size = vector_like_size(right);
  if (left_size > 0 && left_size == right_size) return vector(each(operation, vector(left), vector(right)), left_size);
  if (left_size > 0 && is_number_like(right) && is_product(operation)) {
    const Term factor = number(right);
    return vector(each(operation, vector(left), {factor, factor, factor}), left_size);
  }
  if (right_size > 0 && is_number_like(left) && operation == Opcode::multiply) {
    const Term factor = number(left);
    return vector(each(operation, vector(right), {factor, factor, factor}), right_size);
  }
  if (!is_color_like(left) && !is_color_like(right)) return std::nullopt;
  const auto a = color(left), b = color(right);
  return a && b ? std::optional(color(each(operation, *a, *b))) : std::nullopt;
}

std::optional<Value> Formulas::equality(const Value& left, const Value& right) const {
  if (is_number_like(left) && is_number_like(right)) return truth(is_equal(number(left), number(right)));
  if (is_boolean_like(left) && is_boolean_like(right)) return truth(is_equal(boolean(left), boolean(right)));
  const std::size_t size = vector_like_size(left);
  const bool are_vectors = size > 0 && size == vector_like_size(right);
  const bool are_colors = is_color_like(left) && is_color_like(right);
  if (!are_vectors && !are_colors) return std::nullopt;
  const TermVector a = are_vectors ? vector(left) : *color(left), b = are_vectors ? vector(right) : *color(right);
  const auto both = [](const Term& x, const Term& y) { return x.apply(Opcode::and_, y); };
  return truth(both(both(is_equal(a[0], b[0]), is_equal(a[1], b[1])), is_equal(a[2], b[2])));
}

std::optional<Value> Formulas::select(const Value& condition, const Value& then, const Value& otherwise) const {
  const Term chosen = boolean(condition);
  const auto each_of = [&](const TermVector& a, const TermVector& b) {
    return TermVector{lang::select(chosen, a[0], b[0]), lang::select(chosen, a[1], b[1]),
                      lang::select(chosen, a[2], b[2])};
  };
  if (is_number_like(then) && is_number_like(otherwise))
    return value(lang::select(chosen, number(then), number(otherwise)));
  if (is_boolean_like(then) && is_boolean_like(otherwise))
    return truth(lang::select(chosen, boolean(then), boolean(otherwise)));
  const std::size_t size = vector_like_size(then);
  if (size > 0 && size == vector_like_size(otherwise)) return vector(each_of(vector(then), vector(otherwise)), size);
  const auto a = color(then), b = color(otherwise);
  if (a && b) return color(each_of(*a, *b));
  const bool are_equal = !holds_formula(then) && !holds_formula(otherwise) && equal(then, otherwise);
  return are_equal ? std::optional(then) : std::nullopt;
}

Value part_of(const Formula& formula, std::size_t i) {
  return Formulas(*formula.heap, formula.builder).value(formula.term(i));
}

std::optional<Value> formula_vector(Heap& heap, std::span<const Value> items) {
  if (items.size() != 2 && items.size() != 3) return std::nullopt;
  if (!std::ranges::all_of(items, is_number_like)) return std::nullopt;
  if (std::ranges::all_of(items, &Value::is_number)) return std::nullopt;
  const auto is_of = [builder = find_formula(items)->formula().builder](const Value& v) {
    return v.is_number() || v.formula().builder == builder;
  };
  if (!std::ranges::all_of(items, is_of)) return std::nullopt;
  const Formulas formulas(heap, items);
  const Term x = formulas.number(items[0]), y = formulas.number(items[1]);
  const Term z = items.size() == 3 ? formulas.number(items[2]) : formulas.constant(0);
  return formulas.vector({x, y, z}, items.size());
}

} // namespace rt::lang
