#include "lang/builtins/builtins.hpp"
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

} // namespace

std::span<const Builtin> vectors() {
  static constexpr Builtin table[] = {
      {"dot", "a: point, b: point", "scalar product", dot_product},
      {"cross", "a: vector, b: vector", "vector product, right-handed", cross_product},
      {"length", "v: point", "length of a vector", length_of},
      {"normalize", "v: point", "the vector of length 1 in the same direction", unit_vector},
      {"distance", "a: point, b: point", "distance between two points", distance_between},
      {"angle_between", "a: point, b: point", "angle between two vectors, 0 to 180 degrees", angle},
      {"project", "v: point, onto: point", "the part of v along another vector", projected},
      {"reflect", "v: point, normal: point", "v mirrored at the plane perpendicular to normal", mirrored},
  };
  return table;
}

} // namespace rt::lang::builtins
