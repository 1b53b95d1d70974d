#include "lang/builtins/builtins.hpp"
#include "lang/builtins/formula_calls.hpp"
#include "lang/builtins/vector_arguments.hpp"
#include "renderer/math/degrees.hpp"

#include <array>
#include <cmath>

namespace rt::lang::builtins {
namespace {

Value triple_product(BuiltinCall& c) {
  return dot(c.vector(0), cross(c.vector(1), c.vector(2)));
}

Value component(BuiltinCall& c) {
  if (!have_equal_sizes(c) || !has_direction(c, 1)) return Value::poison();
  return dot(c.vector(0), c.vector(1)) / length(c.vector(1));
}

Value direction_angles(BuiltinCall& c) {
  if (!has_direction(c, 0)) return Value::poison();
  const Vec3& v = c.vector(0);
  // In the same way as angles between vectors: accurate near 0 and 180 degrees.
  const auto angle = [](double along, double b, double d) { return atan2_degrees(std::hypot(b, d), along); };
  return Vec3{angle(v.x, v.y, v.z), angle(v.y, v.x, v.z), angle(v.z, v.x, v.y)};
}

// Snell's law in vector form: for unit vectors i and n, with c = -i·n and k = 1 - r² (1 - c²), the direction is r i +
// (r c - √k) n; if k < 0 the reflection is total.
Value refracted(BuiltinCall& c) {
  if (!have_equal_sizes(c) || !has_direction(c, 0) || !has_direction(c, 1)) return Value::poison();
  const double ratio = c.number(2);
  if (!(ratio > 0))
    return c.fail(2, "the ratio of two indices of refraction is greater than 0", "this is " + format_number(ratio));
  const Vec3 i = normalize(c.vector(0));
  Vec3 n = normalize(c.vector(1));
  if (dot(i, n) > 0) n = -n;
  const double cosine = -dot(i, n), k = 1 - ratio * ratio * (1 - cosine * cosine);
  if (k < 0) return {};
  const Vec3 direction = i * ratio + n * (ratio * cosine - std::sqrt(k));
  return c[0].vector_size() == 2 ? Value::point(direction.x, direction.y) : Value(direction);
}

Value plane_through(BuiltinCall& c) {
  const Vec3 n = cross(c.vector(1) - c.vector(0), c.vector(2) - c.vector(0));
  if (length(n) == 0) return c.fail(2, "three points on one line lie in many planes", "");
  const Vec3 unit = normalize(n);
  return make_record(c.heap(), {{c.symbols().find("normal"), unit, {}, {}},
                                {c.symbols().find("offset"), dot(unit, c.vector(0)), {}, {}}});
}

Value distance_to_plane(BuiltinCall& c) {
  const std::string shape = "a plane is a record { normal: …, offset: … }, as `plane_through` gives it";
  if (!c[1].is(ValueKind::record)) return c.fail(1, shape, "this is " + describe(c[1]));
  const Value* normal = c[1].record().find(c.symbols().find("normal"));
  const Value* offset = c[1].record().find(c.symbols().find("offset"));
  if (!normal || !normal->is_vector3() || !offset || !offset->is_number()) return c.fail(1, shape, "");
  if (length(normal->vector()) == 0) return c.fail(1, "a plane's normal has a direction", "");
  return std::abs(dot(normalize(normal->vector()), c.vector(0)) - offset->number());
}

// Along the common perpendicular; for parallel lines it is the distance of a point from the other line.
Value distance_between_lines(BuiltinCall& c) {
  if (!has_direction(c, 1) || !has_direction(c, 3)) return Value::poison();
  const Vec3 between = c.vector(2) - c.vector(0);
  const Vec3 u = normalize(c.vector(1)), v = normalize(c.vector(3)), n = cross(u, v);
  if (length(n) < 1e-12) return length(cross(between, u));
  return std::abs(dot(between, n)) / length(n);
}

Value cylindrical(BuiltinCall& c) {
  const Vec3& p = c.vector(0);
  return Vec3{std::hypot(p.x, p.y), atan2_degrees(p.y, p.x), p.z};
}
Value from_cylindrical(BuiltinCall& c) {
  const Vec3& p = c.vector(0);
  return Vec3{p.x * cos_degrees(p.y), p.x * sin_degrees(p.y), p.z};
}
Value spherical(BuiltinCall& c) {
  const Vec3& p = c.vector(0);
  const double r = std::hypot(p.x, p.y);
  return Vec3{length(p), atan2_degrees(p.y, p.x), atan2_degrees(r, p.z)};
}
Value from_spherical(BuiltinCall& c) {
  const Vec3& p = c.vector(0);
  const double r = p.x * sin_degrees(p.z);
  return Vec3{r * cos_degrees(p.y), r * sin_degrees(p.y), p.x * cos_degrees(p.z)};
}

// The same where a vector depends on the point.

Value triple_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  return c.formulas.value(dot(c.vector(0), cross(c.vector(1), c.vector(2))));
}
Value component_formula(BuiltinCall& call) {
  if (!have_equal_sizes(call)) return Value::poison();
  const FormulaCall c(call);
  return c.formulas.value(dot(c.vector(0), c.vector(1)) / length(c.vector(1)));
}
/// `f` of a vector, a vector.
template <auto f>
Value vector_formula(BuiltinCall& call) {
  const FormulaCall c(call);
  return c.like(0, f(c.vector(0)));
}
TermVector cylindrical_terms(const TermVector& p) {
  return {p[0].apply(Opcode::hypotenuse, p[1]), p[1].apply(Opcode::arc_tangent2, p[0]), p[2]};
}
TermVector from_cylindrical_terms(const TermVector& p) {
  return {p[0] * p[1].apply(Opcode::cosine), p[0] * p[1].apply(Opcode::sine), p[2]};
}
TermVector spherical_terms(const TermVector& p) {
  const Term r = p[0].apply(Opcode::hypotenuse, p[1]);
  return {length(p), p[1].apply(Opcode::arc_tangent2, p[0]), r.apply(Opcode::arc_tangent2, p[2])};
}
TermVector from_spherical_terms(const TermVector& p) {
  const Term r = p[0] * p[2].apply(Opcode::sine);
  return {r * p[1].apply(Opcode::cosine), r * p[1].apply(Opcode::sine), p[0] * p[2].apply(Opcode::cosine)};
}

// Matrices: lists of rows.

struct Matrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> numbers;
  double& at(std::size_t i, std::size_t k) { return numbers[i * columns + k]; }
  double at(std::size_t i, std::size_t k) const { return numbers[i * columns + k]; }
};

std::optional<Matrix> matrix_argument(BuiltinCall& c, std::size_t argument) {
  const auto wrong = [&] {
    c.fail(argument, "a matrix is a list of rows with as many numbers in each", "");
    return std::nullopt;
  };
  const Value& list = c[argument];
  if (!list.is(ValueKind::list)) return wrong();
  Matrix m;
  m.rows = sequence_size(list);
  for (const Value& row : list.items()) {
    if (!is_sequence(row) || row.is(ValueKind::range)) return wrong();
    const std::size_t n = sequence_size(row);
    if (n == 0 || (m.columns != 0 && n != m.columns)) return wrong();
    m.columns = n;
    c.spend(n, n * sizeof(double));
    for (std::size_t i = 0; i < n; ++i) {
      const Value number = sequence_at(row, i);
      if (!number.is_number()) return wrong();
      m.numbers.push_back(number.number());
    }
  }
  return m.rows == 0 ? wrong() : std::optional(m);
}

std::optional<Matrix> square_argument(BuiltinCall& c) {
  auto m = matrix_argument(c, 0);
  if (!m || m->rows == m->columns) return m;
  c.fail(0, "this takes a matrix with as many rows as columns", "");
  return std::nullopt;
}

Value as_value(BuiltinCall& c, const Matrix& m) {
  std::vector<Value> rows;
  for (std::size_t i = 0; i < m.rows; ++i) {
    const auto begin = m.numbers.begin() + static_cast<std::ptrdiff_t>(i * m.columns);
    rows.push_back(make_list(c.heap(), std::vector<Value>(begin, begin + static_cast<std::ptrdiff_t>(m.columns))));
  }
  return make_list(c.heap(), std::move(rows));
}

/// A vector counts as a column.
std::optional<Matrix> factor_argument(BuiltinCall& c, bool& is_vector) {
  const std::size_t n = is_sequence(c[1]) && !c[1].is(ValueKind::range) ? sequence_size(c[1]) : 0;
  is_vector = n > 0 && sequence_at(c[1], 0).is_number();
  if (!is_vector) return matrix_argument(c, 1);
  Matrix m{n, 1, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const Value number = sequence_at(c[1], i);
    if (!number.is_number()) return c.fail(1, "a vector holds numbers alone", ""), std::nullopt;
    m.numbers.push_back(number.number());
  }
  return m;
}

Value matrix_product(BuiltinCall& c) {
  bool is_vector = false;
  const auto a = matrix_argument(c, 0);
  const auto b = a ? factor_argument(c, is_vector) : std::nullopt;
  if (!b) return Value::poison();
  if (a->columns != b->rows)
    return c.fail(1, "the second factor needs as many rows as the first has columns",
                  std::to_string(b->rows) + ", not " + std::to_string(a->columns));
  c.spend(a->rows * a->columns * b->columns, a->rows * b->columns * sizeof(double));
  Matrix m{a->rows, b->columns, std::vector<double>(a->rows * b->columns)};
  for (std::size_t i = 0; i < m.rows; ++i) {
    for (std::size_t k = 0; k < m.columns; ++k) {
      for (std::size_t j = 0; j < a->columns; ++j) m.at(i, k) += a->at(i, j) * b->at(j, k);
    }
  }
  return is_vector ? make_list(c.heap(), std::vector<Value>(m.numbers.begin(), m.numbers.end())) : as_value(c, m);
}

Value transposed(BuiltinCall& c) {
  const auto m = matrix_argument(c, 0);
  if (!m) return Value::poison();
  Matrix t{m->columns, m->rows, std::vector<double>(m->numbers.size())};
  for (std::size_t i = 0; i < m->rows; ++i) {
    for (std::size_t k = 0; k < m->columns; ++k) t.at(k, i) = m->at(i, k);
  }
  return as_value(c, t);
}

/// Gaussian elimination with partial pivoting, on `m` and at the same time on `right`; returns the determinant. If that
/// is not 0, `right` becomes m⁻¹ right.
double eliminate(Matrix m, Matrix& right) {
  double determinant = 1;
  const auto swap_rows = [](Matrix& x, std::size_t i, std::size_t k) {
    for (std::size_t j = 0; j < x.columns; ++j) std::swap(x.at(i, j), x.at(k, j));
  };
  const auto subtract = [](Matrix& x, std::size_t i, std::size_t k, double factor) {
    for (std::size_t j = 0; j < x.columns; ++j) x.at(i, j) -= factor * x.at(k, j);
  };
  for (std::size_t k = 0; k < m.rows; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < m.rows; ++i) {
      if (std::abs(m.at(i, k)) > std::abs(m.at(pivot, k))) pivot = i;
    }
    if (m.at(pivot, k) == 0) return 0;
    if (pivot != k) swap_rows(m, pivot, k), swap_rows(right, pivot, k), determinant = -determinant;
    const double head = m.at(k, k);
    determinant *= head;
    for (std::size_t i = 0; i < m.rows; ++i) {
      const double factor = m.at(i, k) / head;
      if (i == k || factor == 0) continue;
      subtract(m, i, k, factor), subtract(right, i, k, factor);
    }
  }
  for (std::size_t i = 0; i < m.rows; ++i) {
    for (std::size_t j = 0; j < right.columns; ++j) right.at(i, j) /= m.at(i, i);
  }
  return determinant;
}

Value determinant(BuiltinCall& c) {
  const auto m = square_argument(c);
  if (!m) return Value::poison();
  c.spend(m->rows * m->rows * m->rows);
  Matrix nothing{m->rows, 0, {}};
  return eliminate(*m, nothing);
}

Value inverse(BuiltinCall& c) {
  const auto m = square_argument(c);
  if (!m) return Value::poison();
  c.spend(2 * m->rows * m->rows * m->rows, m->numbers.size() * sizeof(double));
  Matrix unit{m->rows, m->rows, std::vector<double>(m->numbers.size())};
  for (std::size_t i = 0; i < m->rows; ++i) unit.at(i, i) = 1;
  if (eliminate(*m, unit) == 0) return c.fail(0, "this matrix has no inverse: its determinant is 0", "");
  return as_value(c, unit);
}

} // namespace

std::span<const Builtin> geometry() {
  static constexpr Builtin table[] = {
      {"triple", "a: vector, b: vector, c: vector", "a · (b × c): the volume that three vectors span, with a sign",
       triple_product, triple_formula},
      {"component", "v: point, along: point", "the length of the projection of v onto another vector, signed",
       component, component_formula},
      {"direction_angles", "v: vector", "the angles to the three axes, in degrees", direction_angles},
      {"refract", "v: point, normal: point, ratio: number",
       "direction behind a surface, of length 1, by Snell's law; ratio is the index in front over that behind; `none` "
       "where the reflection is total",
       refracted},
      {"plane_through", "a: vector, b: vector, c: vector",
       "the plane through three points: { normal, offset }, the normal of length 1", plane_through},
      {"distance_to_plane", "p: vector, plane: any", "distance of a point from a plane { normal, offset }",
       distance_to_plane},
      {"distance_between_lines", "p: vector, u: vector, q: vector, v: vector",
       "distance of the lines through p along u and through q along v", distance_between_lines},
      {"cylindrical", "p: vector", "[r, θ, z] of a point: θ from the x axis about z, in degrees", cylindrical,
       vector_formula<cylindrical_terms>},
      {"from_cylindrical", "p: vector", "the point at [r, θ, z]", from_cylindrical,
       vector_formula<from_cylindrical_terms>},
      {"spherical", "p: vector", "[ρ, θ, φ] of a point: θ from the x axis about z, φ from the z axis, in degrees",
       spherical, vector_formula<spherical_terms>},
      {"from_spherical", "p: vector", "the point at [ρ, θ, φ]", from_spherical, vector_formula<from_spherical_terms>},
      {"matmul", "a: list, b: list", "product of two matrices (lists of rows), or of a matrix and a vector",
       matrix_product},
      {"transpose", "m: list", "the transposed matrix", transposed},
      {"determinant", "m: list", "determinant of a square matrix", determinant},
      {"inverse", "m: list", "inverse of a square matrix", inverse},
  };
  return table;
}

} // namespace rt::lang::builtins
