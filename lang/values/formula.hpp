#pragma once

#include "lang/values/term.hpp"
#include "lang/values/value.hpp"

#include <memory>
#include <optional>
#include <span>

namespace rt::lang {

/// What a formula will be, once the point is known.
enum class FormulaType : std::uint8_t { number, boolean, vector, color };

/// A value that depends on the point at which a function is evaluated. A function of the scene's is compiled by calling
/// it once with a point that is a formula: what is computed with it becomes the instructions of the function that is
/// being built.
struct Formula : Cell {
  static constexpr ValueKind cell_kind = ValueKind::formula;
  std::shared_ptr<FunctionBuilder> builder;
  FormulaType type = FormulaType::number;
  std::uint8_t size = 1; ///< of a vector 2 or 3, of a colour 3
  std::array<FunctionBuilder::Node, 3> parts{};

  Term term(std::size_t i) const { return {*builder, parts[i]}; }
};

inline bool is_formula(const Value& value, FormulaType type) {
  return value.is(ValueKind::formula) && value.formula().type == type;
}
/// A number, known or not; a vector, and so on.
bool is_number_like(const Value& value);
bool is_boolean_like(const Value& value);
/// How many numbers a vector has, known or not; 0 for what is none.
std::size_t vector_like_size(const Value& value);

/// Whether there is a formula in it, at any depth of lists and records.
bool holds_formula(const Value& value);
bool holds_formula(std::span<const Value> values);

/// Turns values into terms of one function and back.
class Formulas {
public:
  /// Of the function whose formulas are among the values; there must be one.
  Formulas(Heap& heap, std::span<const Value> values);
  Formulas(Heap& heap, std::shared_ptr<FunctionBuilder> builder) : heap_(heap), builder_(std::move(builder)) {}

  const std::shared_ptr<FunctionBuilder>& builder() const { return builder_; }
  Term constant(double value) const { return {*builder_, value}; }
  Term number(const Value& value) const;
  Term boolean(const Value& value) const;
  TermVector vector(const Value& value) const;
  /// Of a colour, or a number as grey; nothing where it is neither.
  std::optional<TermVector> color(const Value& value) const;

  /// Back: a formula, or a value where all is constant.
  Value value(const Term& number) const { return make(FormulaType::number, {&number, 1}); }
  Value truth(const Term& truth) const { return make(FormulaType::boolean, {&truth, 1}); }
  /// Of the first `size` terms.
  Value vector(const TermVector& terms, std::size_t size) const {
    return make(FormulaType::vector, std::span(terms).first(size));
  }
  Value color(const TermVector& terms) const { return make(FormulaType::color, terms); }

  /// An arithmetic operation of the language; nothing where it is not defined for these types.
  std::optional<Value> arithmetic(Opcode operation, const Value& left, const Value& right) const;
  /// Whether two values are equal; nothing where it cannot be said by a formula.
  std::optional<Value> equality(const Value& left, const Value& right) const;
  /// One of two values of the same type; nothing where they are not.
  std::optional<Value> select(const Value& condition, const Value& then, const Value& otherwise) const;

private:
  Value make(FormulaType type, std::span<const Term> terms) const;

  Heap& heap_;
  std::shared_ptr<FunctionBuilder> builder_;
};

/// One of the numbers of a formula.
Value part_of(const Formula& formula, std::size_t i);

/// A list of two or three numbers of which some are formulas, as a vector; nothing for any other.
std::optional<Value> formula_vector(Heap& heap, std::span<const Value> items);

inline Formula& Value::formula() const {
  return *static_cast<Formula*>(expect(ValueKind::formula).cell);
}

} // namespace rt::lang
