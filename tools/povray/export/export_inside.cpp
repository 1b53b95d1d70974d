#include "tools/povray/export/export_parts.hpp"

#include <algorithm>
#include <cmath>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

double square(const Vec3& v) {
  return dot(v, v);
}

// Between two discs, with a radius that varies linearly from one to the other.
bool is_between(const Vec3& from, const Vec3& to, double first, double last, const Vec3& p) {
  const double share = dot(p - from, to - from) / square(to - from);
  const double radius = first + share * (last - first);
  return share > 0 && share < 1 && square(p - (from + (to - from) * share)) < radius * radius;
}

} // namespace

bool holds(const Sphere& s, const Vec3& p) {
  return square(p) < s.radius * s.radius;
}

bool holds(const Plane& plane, const Vec3& p) {
  if (plane.x) return p.x < *plane.x;
  if (plane.y) return p.y < *plane.y;
  if (plane.z) return p.z < *plane.z;
  return dot(unit(plane.normal.value_or(Vec3{0, 1, 0})), p) < plane.offset.value_or(0);
}

bool holds(const Box& b, const Vec3& p) {
  const Vec3 half = b.size.value_or(Vec3{1, 1, 1}) / 2;
  const Vec3 q = b.from.value_or(-half), r = b.to.value_or(half);
  const Vec3 low = min(q, r), high = max(q, r);
  return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y && p.z < high.z;
}

bool holds(const Cylinder& c, const Vec3& p) {
  const Vec3 axis = c.from && c.to ? *c.to - *c.from : unit(c.axis.value_or(Vec3{0, 1, 0})) * c.height.value_or(1);
  const Vec3 from = c.from ? *c.from : axis * -0.5;
  if (!c.infinite) return is_between(from, from + axis, c.radius, c.radius, p);
  return square(cross(p - from, unit(axis))) < c.radius * c.radius;
}

bool holds(const Cone& c, const Vec3& p) {
  return is_between(c.from, c.to, c.radius, c.top_radius, p);
}

// POV-Ray's disc has everything below it as its inside.
bool holds(const Disc& d, const Vec3& p) {
  return dot(d.normal, p) < 0;
}

bool holds(const Triangle&, const Vec3&) {
  return false;
}
bool holds(const Quad&, const Vec3&) {
  return false;
}
bool holds(const Polygon&, const Vec3&) {
  return false;
}

bool holds_in_povray(const Scene& scene, const Object& object, const Map& placement, const Vec3& point) {
  if (!object.is_visible) return false;
  const Vec3 p = inverse(placement).point(point);
  const auto part = [&](const Object& o) { return holds_in_povray(scene, o, map_of(placement_of(scene, o)), p); };
  if (object.shape.kind == kind_of<Group>) {
    const auto& members = scene.shapes.get<Group>(object.shape).members;
    return std::any_of(members.begin(), members.end(), part);
  }
  if (object.shape.kind == kind_of<Combination>) {
    const auto& c = scene.shapes.get<Combination>(object.shape);
    std::vector<Object> parts;
    std::copy_if(c.operands.begin(), c.operands.end(), std::back_inserter(parts),
                 [](const Object& o) { return o.is_visible; });
    if (parts.empty()) return false;
    switch (c.operation) {
    case Combination::Operation::unite:
      return std::any_of(parts.begin(), parts.end(), part);
    case Combination::Operation::intersect:
      return std::all_of(parts.begin(), parts.end(), part);
    case Combination::Operation::subtract:
      return part(parts.front()) && std::none_of(parts.begin() + 1, parts.end(), part);
    }
  }
  return scene.shapes.visit(object.shape, [&]<class S>(const S& shape) {
    if constexpr (is_composite<S>)
      return false; // not reached
    else
      return holds(shape, p);
  });
}

Placement placement_of(const Scene& scene, const Object& o) {
  Placement placement =
      o.transform == no_transform ? Placement{} : scene.transforms[static_cast<std::size_t>(o.transform)];
  placement.at = o.at;
  return placement;
}

} // namespace rt::tools::povray
