#pragma once

#include "lang/values/builtin.hpp"
#include "lang/values/formula.hpp"

namespace rt::lang::builtins {

/// The arguments of a call, some of which depend on the point: as terms of the function that is being built.
class FormulaCall {
public:
  explicit FormulaCall(BuiltinCall& call) : formulas(call.heap(), call.arguments), call_(call) {}

  Term number(std::size_t i) const { return formulas.number(call_[i]); }
  Term number_or(std::size_t i, double otherwise) const {
    return call_.has(i) ? number(i) : formulas.constant(otherwise);
  }
  TermVector vector(std::size_t i) const { return formulas.vector(call_[i]); }
  /// A vector of the size of argument `i`.
  Value like(std::size_t i, const TermVector& v) const { return formulas.vector(v, vector_like_size(call_[i])); }

  const Formulas formulas;

private:
  BuiltinCall& call_;
};

/// A built-in function of numbers that is one operation.
template <Opcode operation>
Value formula_of(BuiltinCall& call) {
  const FormulaCall c(call);
  if constexpr (operand_count(operation) == 1)
    return c.formulas.value(c.number(0).apply(operation));
  else
    return c.formulas.value(c.number(0).apply(operation, c.number(1)));
}

/// A function of a number, or of each number of a vector.
template <auto f>
Value formula_of_each(BuiltinCall& call) {
  const FormulaCall c(call);
  if (is_number_like(call[0])) return c.formulas.value(f(c.number(0)));
  const TermVector v = c.vector(0);
  return c.like(0, {f(v[0]), f(v[1]), f(v[2])});
}
template <Opcode operation>
Term term_of(const Term& x) {
  return x.apply(operation);
}

} // namespace rt::lang::builtins
