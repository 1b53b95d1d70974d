#include "lang/builtins/builtins.hpp"

#include <cmath>

namespace rt::lang {
namespace {

using scene::Step;

bool is_finite_argument(BuiltinCall& c, std::size_t i) {
  if (!c.has(i)) return true;
  const bool fine =
      c[i].is_number() ? std::isfinite(c.number(i)) : !c[i].is(ValueKind::vector) || is_finite(c.vector(i));
  if (!fine) c.fail(i, "this is not a finite number");
  return fine;
}

bool are_finite(BuiltinCall& c) {
  for (std::size_t i = 0; i < c.arguments.size(); ++i) {
    if (!is_finite_argument(c, i)) return false;
  }
  return true;
}

/// A vector given as a whole (argument 0) or by the named x, y, z (arguments 1 to 3), which default to `otherwise`.
std::optional<Vec3> vector_or_parts(BuiltinCall& c, double otherwise) {
  if (!are_finite(c)) return std::nullopt;
  const bool has_parts = c.has(1) || c.has(2) || c.has(3);
  if (c.has(0) && has_parts) {
    c.fail(0, "write either one vector or the named x, y and z, not both");
    return std::nullopt;
  }
  if (!c.has(0) && !has_parts) {
    c.fail(0, "write a vector, or one or more of x, y and z by name: `(y: 1)`");
    return std::nullopt;
  }
  if (c.has(0)) return c[0].is_number() ? Vec3{c.number(0), c.number(0), c.number(0)} : c.vector(0);
  return Vec3{c.number_or(1, otherwise), c.number_or(2, otherwise), c.number_or(3, otherwise)};
}

Vec3 about(BuiltinCall& c, std::size_t i) {
  return c.has(i) ? c.vector(i) : Vec3{};
}

std::optional<Step> scale(BuiltinCall& c) {
  const auto factors = vector_or_parts(c, 1);
  if (!factors) return std::nullopt;
  if (factors->x * factors->y * factors->z == 0) {
    c.fail(c.has(0)                      ? 0
           : c.has(1) && factors->x == 0 ? 1
           : c.has(2) && factors->y == 0 ? 2
                                         : 3,
           "scaling by 0 flattens the thing");
    return std::nullopt;
  }
  return scene::ScaleStep{*factors, about(c, 4)};
}

std::optional<Step> rotate(BuiltinCall& c) {
  constexpr std::size_t axis = 4, angle = 5, fixed = 6;
  if (!c.has(axis) && !c.has(angle)) {
    const auto degrees = vector_or_parts(c, 0);
    if (!degrees) return std::nullopt;
    return scene::RotateStep{*degrees, about(c, fixed)};
  }
  if (!are_finite(c)) return std::nullopt;
  if (!c.has(axis) || !c.has(angle) || c.has(0) || c.has(1) || c.has(2) || c.has(3)) {
    c.fail(c.has(axis) ? axis : angle, "`axis` and `angle` must be given together, and without x, y, z");
    return std::nullopt;
  }
  if (length(c.vector(axis)) == 0) {
    c.fail(axis, "the axis of a rotation must not be the zero vector", "this has length 0");
    return std::nullopt;
  }
  return scene::RotateAxisStep{c.vector(axis), c.number(angle), about(c, fixed)};
}

std::optional<Step> move(BuiltinCall& c) {
  const auto offset = vector_or_parts(c, 0);
  if (!offset) return std::nullopt;
  return scene::MoveStep{*offset};
}

std::optional<Step> shear(BuiltinCall& c) {
  if (!are_finite(c)) return std::nullopt;
  const scene::ShearStep step{c.number_or(0, 0), c.number_or(1, 0), c.number_or(2, 0), c.number_or(3, 0),
                              c.number_or(4, 0), c.number_or(5, 0), about(c, 6)};
  if (scene::matrix(step).determinant() != 0) return step;
  c.fail(0, "this shear flattens the thing");
  return std::nullopt;
}

std::optional<Step> mirror(BuiltinCall& c) {
  const auto normal = vector_or_parts(c, 0);
  if (!normal) return std::nullopt;
  if (length(*normal) == 0) {
    c.fail(0, "a mirror needs a direction", "this has length 0");
    return std::nullopt;
  }
  return scene::MirrorStep{*normal, about(c, 4)};
}

/// The row of a matrix given as lists: three or four numbers.
std::optional<std::array<double, 4>> row_of(const Value& row) {
  if (!is_sequence(row) || row.is(ValueKind::range)) return std::nullopt;
  const std::size_t n = sequence_size(row);
  if (n != 3 && n != 4) return std::nullopt;
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < n; ++i) {
    const Value number = sequence_at(row, i);
    if (!number.is_number() || !std::isfinite(number.number())) return std::nullopt;
    numbers[i] = number.number();
  }
  return numbers;
}

std::optional<Step> transform(BuiltinCall& c) {
  const auto wrong = [&](const std::string& message) {
    c.fail(0, message);
    return std::nullopt;
  };
  const std::string shape = "a matrix is 3 rows of 3 or 4 numbers, or 4 rows of 4 with [0, 0, 0, 1] last";
  const std::size_t n = c[0].is(ValueKind::list) ? c[0].items().size() : 0;
  if (n != 3 && n != 4) return wrong(shape);
  std::array<std::array<double, 4>, 4> m{};
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = row_of(c[0].items()[i]);
    if (!row || (n == 4 && sequence_size(c[0].items()[i]) != 4)) return wrong(shape);
    m[i] = *row;
  }
  if (n == 4 && m[3] != std::array<double, 4>{0, 0, 0, 1}) return wrong(shape);
  const Affine map{{m[0][0], m[1][0], m[2][0]},
                   {m[0][1], m[1][1], m[2][1]},
                   {m[0][2], m[1][2], m[2][2]},
                   {m[0][3], m[1][3], m[2][3]}};
  const double determinant = map.determinant();
  if (determinant == 0 || !std::isfinite(determinant))
    return wrong("this matrix flattens the thing: its determinant is 0");
  return scene::MatrixStep{map};
}

} // namespace

std::span<const ChainMethod> chain_methods() {
  static constexpr ChainMethod table[] = {
      {"scale", "factors: number or vector = ?, x: number = 1, y: number = 1, z: number = 1, about: vector = [0, 0, 0]",
       "scaled about a fixed point", scale},
      {"rotate",
       "degrees: vector = ?, x: number = 0, y: number = 0, z: number = 0, axis: vector = ?, angle: number = ?, about: "
       "vector = [0, 0, 0]",
       "rotated about the x, then the y, then the z axis, or by an angle about any axis, in degrees", rotate},
      {"move", "offset: vector = ?, x: number = 0, y: number = 0, z: number = 0", "moved", move},
      {"shear",
       "xy: number = 0, xz: number = 0, yx: number = 0, yz: number = 0, zx: number = 0, zy: number = 0, about: vector "
       "= [0, 0, 0]",
       "sheared: xy times y and xz times z are added to x, and so on", shear},
      {"mirror", "normal: vector = ?, x: number = 0, y: number = 0, z: number = 0, about: vector = [0, 0, 0]",
       "mirrored about the plane perpendicular to a direction", mirror},
      {"transform", "matrix: list", "transformed by a matrix, 3 rows of 4 numbers: p becomes M p", transform},
  };
  return table;
}

const ChainMethod* find_chain_method(std::string_view name) {
  for (const ChainMethod& method : chain_methods()) {
    if (method.name == name) return &method;
  }
  return nullptr;
}

} // namespace rt::lang
