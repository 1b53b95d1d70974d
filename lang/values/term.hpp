#pragma once

#include "renderer/functions/function_builder.hpp"

#include <array>

namespace rt::lang {

/// A number of a function that is being built, so that formulas can be written like formulas: what is computed with it
/// becomes instructions, in the order in which it stands there.
class Term {
public:
  using Node = FunctionBuilder::Node;

  Term(FunctionBuilder& builder, Node node) : builder_(&builder), node_(node) {}
  Term(FunctionBuilder& builder, double value) : builder_(&builder), node_(builder.constant(value)) {}

  Node node() const { return node_; }
  FunctionBuilder& builder() const { return *builder_; }
  /// A constant of the same function.
  Term of(double value) const { return {*builder_, value}; }
  Term apply(Opcode operation) const { return {*builder_, builder_->apply(operation, node_)}; }
  Term apply(Opcode operation, const Term& b) const { return {*builder_, builder_->apply(operation, node_, b.node_)}; }
  Term apply(Opcode operation, double b) const { return apply(operation, of(b)); }

private:
  FunctionBuilder* builder_;
  Node node_;
};

inline Term operator-(const Term& a) {
  return a.apply(Opcode::negate);
}
inline Term operator+(const Term& a, const Term& b) {
  return a.apply(Opcode::add, b);
}
inline Term operator+(const Term& a, double b) {
  return a + a.of(b);
}
inline Term operator+(double a, const Term& b) {
  return b.of(a) + b;
}
inline Term operator-(const Term& a, const Term& b) {
  return a.apply(Opcode::subtract, b);
}
inline Term operator-(const Term& a, double b) {
  return a - a.of(b);
}
inline Term operator-(double a, const Term& b) {
  return b.of(a) - b;
}
inline Term operator*(const Term& a, const Term& b) {
  return a.apply(Opcode::multiply, b);
}
inline Term operator*(const Term& a, double b) {
  return a * a.of(b);
}
inline Term operator*(double a, const Term& b) {
  return b.of(a) * b;
}
inline Term operator/(const Term& a, const Term& b) {
  return a.apply(Opcode::divide, b);
}
inline Term operator/(const Term& a, double b) {
  return a / a.of(b);
}

/// A truth value, for `select`.
inline Term is_less(const Term& a, const Term& b) {
  return a.apply(Opcode::less, b);
}
inline Term is_equal(const Term& a, const Term& b) {
  return a.apply(Opcode::equal, b);
}
inline Term select(const Term& condition, const Term& then, const Term& otherwise) {
  FunctionBuilder& builder = condition.builder();
  return {builder, builder.apply(Opcode::select, condition.node(), then.node(), otherwise.node())};
}
inline Term sqrt(const Term& a) {
  return a.apply(Opcode::square_root);
}
inline Term abs(const Term& a) {
  return a.apply(Opcode::absolute);
}
/// As std::clamp has it.
inline Term clamp(const Term& x, const Term& low, const Term& high) {
  return x.apply(Opcode::maximum, low).apply(Opcode::minimum, high);
}

/// A vector; of one in the plane, z is 0.
using TermVector = std::array<Term, 3>;

inline TermVector operator-(const TermVector& a, const TermVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline TermVector operator*(const TermVector& a, const Term& s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
inline TermVector operator/(const TermVector& a, const Term& s) {
  return {a[0] / s, a[1] / s, a[2] / s};
}
inline Term dot(const TermVector& a, const TermVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline TermVector cross(const TermVector& a, const TermVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Term length(const TermVector& a) {
  return sqrt(dot(a, a));
}
inline TermVector normalize(const TermVector& a) {
  return a / length(a);
}

} // namespace rt::lang
