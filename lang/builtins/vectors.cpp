#include "lang/builtins/builtins.hpp"
#include "lang/builtins/formula_calls.hpp"
#include "lang/builtins/vector_arguments.hpp"
#include "renderer/math/degrees.hpp"

#include <algorithm>
#include <cmath>

namespace rt::lang::builtins {
namespace {

/// A result of the same size as argument 0: 2D vectors stay 2D.
Value like_first(BuiltinCall& c, const Vec3& v) {
  return c[0].vector_size() == 2 ? Value::point(v.x, v.y) : Value(v);
}

Value dot_product(BuiltinCall& c) {
  return have_equal_sizes(c) ? Value(dot(c.vector(0), c.vector(1))) : Value::poison();
}
Value cross_product(BuiltinCall& c) {
  return cross(c.vector(0), c.vector(1));
}
Value length_of(BuiltinCall& c) {
  return length(c.vector(0));
}
Value unit_vector(BuiltinCall& c) {
  return has_direction(c, 0) ? like_first(c, normalize(c.vector(0))) : Value::poison();
}
Value distance_between(BuiltinCall& c) {
  return have_equal_sizes(c) ? Value(length(c.vector(1) - c.vector(0))) : Value::poison();
}

// atan2 of sine and cosine is accurate where acos of the cosine alone loses half the digits: near 0 and 180 degrees.
Value angle(BuiltinCall& c) {
  if (!have_equal_sizes(c) || !has_direction(c, 0) || !has_direction(c, 1)) return Value::poison();
  const Vec3 &a = c.vector(0), &b = c.vector(1);
  return atan2_degrees(length(cross(a, b)), dot(a, b));
}

Value projected(BuiltinCall& c) {
  if (!have_equal_sizes(c) || !has_direction(c, 1)) return Value::poison();
  const Vec3 &a = c.vector(0), &b = c.vector(1);
  return like_first(c, b * (dot(a, b) / dot(b, b)));
}

Value mirrored(BuiltinCall& c) {
  if (!have_equal_sizes(c) || !has_direction(c, 1)) return Value::poison();
  const Vec3 n = normalize(c.vector(1));
  return like_first(c, c.vector(0) - n * (2 * dot(n, c.vector(0))));
}

// The same where a vector depends on the point. That of length 0 has no direction and then gives no number.

/// `f` of both vectors, a number.
template <auto f>
Value number_of_two(BuiltinCall& call) {
  if (!have_equal_sizes(call)) return Value::poison();
  const FormulaCall c(call);
  return c.formulas.value(f(c.vector(0), c.vector(1)));
}
/// `f` of both vectors, a vector of the first one's size.
template <auto f>
Value vector_of_two(BuiltinCall& call) {
  if (!have_equal_sizes(call)) return Value::poison();
  const FormulaCall c(call);
  return c.like(0, f(c.vector(0), c.vector(1)));
}

Term dot_term(const TermVector& a, const TermVector& b) {
  return dot(a, b);
}
TermVector cross_terms(const TermVector& a, const TermVector& b) {
  return cross(a, b);
}
Term distance_term(const TermVector& a, const TermVector& b) {
  return length(b - a);
}
Term angle_term(const TermVector& a, const TermVector& b) {
  return length(cross(a, b)).apply(Opcode::arc_tangent2, dot(a, b));
}
TermVector projected_terms(const TermVector& a, const TermVector& b) {
  return b * (dot(a, b) / dot(b, b));
}
TermVector mirrored_terms(const TermVector& a, const TermVector& b) {
  const TermVector n = normalize(b);
  return a - n * (2 * dot(n, a));
}
Value length_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  return c.formulas.value(length(c.vector(0)));
}
Value unit_vector_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  return c.like(0, normalize(c.vector(0)));
}

} // namespace

std::span<const Builtin> vectors() {
  static constexpr Builtin table[] = {
      {"dot", "a: point, b: point", "dot product", dot_product, number_of_two<dot_term>},
      {"cross", "a: vector, b: vector", "cross product, right-handed", cross_product, vector_of_two<cross_terms>},
      {"length", "v: point", "length of a vector", length_of, length_formula},
      {"normalize", "v: point", "the unit vector in the same direction", unit_vector, unit_vector_formula},
      {"distance", "a: point, b: point", "distance between two points", distance_between, number_of_two<distance_term>},
      {"angle_between", "a: point, b: point", "angle between two vectors, 0 to 180 degrees", angle,
       number_of_two<angle_term>},
      {"project", "v: point, onto: point", "the projection of v onto another vector", projected,
       vector_of_two<projected_terms>},
      {"reflect", "v: point, normal: point", "v reflected about the plane perpendicular to normal", mirrored,
       vector_of_two<mirrored_terms>},
  };
  return table;
}

} // namespace rt::lang::builtins
