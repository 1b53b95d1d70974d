#include "tools/povray/export/map.hpp"

#include <cmath>
#include <numbers>

namespace rt::tools::povray {
namespace {

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180);
}

Map moving(const Vec3& offset) {
  Map map;
  map.row[3] = offset;
  return map;
}

Map scaling(const Vec3& factors) {
  Map map;
  for (std::size_t axis = 0; axis < 3; ++axis) map.row[axis][axis] = factors[axis];
  return map;
}

// Rotates the plane of the two axes, from `first` towards `second`.
Map turning(std::size_t first, std::size_t second, double degrees) {
  Map map;
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  map.row[first][first] = c;
  map.row[first][second] = s;
  map.row[second][first] = -s;
  map.row[second][second] = c;
  return map;
}

Map rotating(const Vec3& degrees) {
  return then(then(turning(1, 2, degrees.x), turning(2, 0, degrees.y)), turning(0, 1, degrees.z));
}

Map about(const Vec3& fixed, const Map& map) {
  if (fixed == Vec3{}) return map;
  return then(then(moving(-fixed), map), moving(fixed));
}

Map map_of(const scene::ScaleStep& step) {
  return about(step.about, scaling(step.factors));
}
Map map_of(const scene::RotateStep& step) {
  return about(step.about, rotating(step.degrees));
}
Map map_of(const scene::MoveStep& step) {
  return moving(step.offset);
}
Map map_of(const scene::MatrixStep& step) {
  return {{step.matrix.x, step.matrix.y, step.matrix.z, step.matrix.translation}};
}

} // namespace

Vec3 unit(const Vec3& v) {
  return v / std::hypot(v.x, v.y, v.z);
}

Vec3 Map::vector(const Vec3& v) const {
  return v.x * row[0] + v.y * row[1] + v.z * row[2];
}
Vec3 Map::point(const Vec3& p) const {
  return vector(p) + row[3];
}

Map then(const Map& a, const Map& b) {
  return {{b.vector(a.row[0]), b.vector(a.row[1]), b.vector(a.row[2]), b.point(a.row[3])}};
}

// By cofactors: the columns of the inverse are the cross products of the rows over the determinant.
Map inverse(const Map& map) {
  const Vec3 &a = map.row[0], &b = map.row[1], &c = map.row[2];
  const double determinant = dot(a, cross(b, c));
  const Vec3 p = cross(b, c) / determinant, q = cross(c, a) / determinant, r = cross(a, b) / determinant;
  Map result{{Vec3{p.x, q.x, r.x}, Vec3{p.y, q.y, r.y}, Vec3{p.z, q.z, r.z}, Vec3{}}};
  result.row[3] = -result.vector(map.row[3]);
  return result;
}

// The rotation as a sum of projections: the part along the unit axis a is unchanged, the rest rotates in its plane, v'
// = a (a·v) + cos·(v − a (a·v)) + sin·(a × v).
Map map_of(const scene::RotateAxisStep& step) {
  const Vec3 a = step.axis / std::hypot(step.axis.x, step.axis.y, step.axis.z);
  const double c = std::cos(radians(step.degrees)), s = std::sin(radians(step.degrees));
  Map map;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 along = a * a[i];
    map.row[i] = along + c * (map.row[i] - along) + s * cross(a, map.row[i]);
  }
  return about(step.about, map);
}

Map map_of(const scene::ShearStep& s) {
  return about(s.about, {{Vec3{1, s.yx, s.zx}, Vec3{s.xy, 1, s.zy}, Vec3{s.xz, s.yz, 1}, Vec3{}}});
}

// I − 2 n nᵀ / (n·n): no square root is needed.
Map map_of(const scene::MirrorStep& step) {
  const Vec3& n = step.normal;
  Map map;
  for (std::size_t i = 0; i < 3; ++i) map.row[i] = map.row[i] - n * (2 * n[i] / dot(n, n));
  return about(step.about, map);
}

Map map_of(const scene::Step& step) {
  return std::visit([](const auto& s) { return map_of(s); }, step);
}

Map map_of(const scene::Placement& placement) {
  Map map = then(then(scaling(placement.scale), rotating(placement.rotate)), moving(placement.at));
  for (const scene::Step& step : placement.chain) map = then(map, map_of(step));
  return map;
}

} // namespace rt::tools::povray
