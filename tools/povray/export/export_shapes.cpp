#include "tools/povray/export/export_parts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::tools::povray {
namespace {

using namespace rt::scene;

Primitive primitive_of(const Sphere& s) {
  return {"sphere", fmt::format("0, {}", number(s.radius))};
}

Primitive primitive_of(const Plane& p) {
  if (p.x) return {"plane", "x, " + number(*p.x)};
  if (p.y) return {"plane", "y, " + number(*p.y)};
  if (p.z) return {"plane", "z, " + number(*p.z)};
  // POV-Ray normalises the normal and measures the offset along it, as we do.
  return {"plane", fmt::format("{}, {}", vector(p.normal.value_or(Vec3{0, 1, 0})), number(p.offset.value_or(0)))};
}

std::string span_of(const Vec3& from, const Vec3& to, double radius, bool open) {
  return fmt::format("{}, {}, {}{}", vector(from), vector(to), number(radius), open ? " open" : "");
}

// |p|² − (a·p)² = r² about the unit axis a through the origin: a quadric, because POV-Ray's cylinders are finite.
Primitive endless_cylinder(const Vec3& through, const Vec3& axis, double radius) {
  const Vec3 a = unit(axis);
  std::string body = fmt::format("{}, {}, <0, 0, 0>, {}", vector({1 - a.x * a.x, 1 - a.y * a.y, 1 - a.z * a.z}),
                                 vector({-2 * a.x * a.y, -2 * a.x * a.z, -2 * a.y * a.z}), number(-radius * radius));
  return {"quadric", body + transform(MoveStep{through})};
}

Primitive primitive_of(const Cylinder& c) {
  if (c.from && c.to) {
    if (c.infinite) return endless_cylinder(*c.from, *c.to - *c.from, c.radius);
    return {"cylinder", span_of(*c.from, *c.to, c.radius, c.open)};
  }
  const Vec3 axis = c.axis.value_or(Vec3{0, 1, 0});
  if (c.infinite) return endless_cylinder({}, axis, c.radius);
  const Vec3 half = unit(axis) * (c.height.value_or(1) / 2);
  return {"cylinder", span_of(-half, half, c.radius, c.open)};
}

// POV-Ray's cone requires two different radii.
Primitive primitive_of(const Cone& c) {
  if (c.radius == c.top_radius) return {"cylinder", span_of(c.from, c.to, c.radius, c.open)};
  return {"cone", fmt::format("{}, {}, {}, {}{}", vector(c.from), number(c.radius), vector(c.to), number(c.top_radius),
                              c.open ? " open" : "")};
}

Primitive primitive_of(const Box& b) {
  const Vec3 half = b.size.value_or(Vec3{1, 1, 1}) / 2;
  const Vec3 p = b.from.value_or(-half), q = b.to.value_or(half);
  return {"box", fmt::format("{}, {}", vector(min(p, q)), vector(max(p, q)))};
}

Primitive primitive_of(const Disc& d) {
  return {"disc", fmt::format("0, {}, {}{}", vector(d.normal), number(d.radius),
                              d.hole > 0 ? ", " + number(d.hole) : std::string{})};
}

Primitive primitive_of(const Triangle& t) {
  const bool has_normals = t.normals.size() == 3;
  std::string body;
  for (std::size_t i = 0; i < 3; ++i) {
    body += (i > 0 ? ", " : "") + vector(t.points[i]);
    if (has_normals) body += ", " + vector(t.normals[i]);
  }
  return {has_normals ? "smooth_triangle" : "triangle", body};
}

// POV-Ray's polygons are closed by repeating the first point.
Primitive outline(const std::vector<Vec3>& points) {
  std::string body = number(static_cast<double>(points.size() + 1));
  for (const Vec3& p : points) body += ", " + vector(p);
  return {"polygon", body + ", " + vector(points.front())};
}

Primitive primitive_of(const Polygon& p) {
  return outline(p.points);
}

Primitive parallelogram(const Vec3& corner, const Vec3& u, const Vec3& v) {
  return outline({corner, corner + u, corner + u + v, corner + v});
}

Primitive primitive_of(const Quad& q) {
  if (q.points) return outline(*q.points);
  if (q.corner && q.edge_u && q.edge_v) return parallelogram(*q.corner, *q.edge_u, *q.edge_v);
  // One edge is horizontal: along y × normal, or along x if the normal is vertical.
  const Vec3 n = unit(q.normal.value_or(Vec3{0, 1, 0}));
  const double tilt = std::hypot(n.x, n.z), size = q.size.value_or(1);
  const Vec3 u = (tilt > 1e-9 ? Vec3{n.z, 0, -n.x} / tilt : Vec3{1, 0, 0}) * size;
  const Vec3 v = cross(n, u);
  return parallelogram((u + v) * -0.5, u, v);
}

Primitive primitive_of(const Group&) {
  return {};
}
Primitive primitive_of(const Combination&) {
  return {};
}

} // namespace

// The slab is cut away by a thinner and narrower one; what is inside it and below the disc is all that remains of the
// disc's inside, because POV-Ray ignores `clipped_by` for that.
Primitive thin_primitive(const Disc& d) {
  const Vec3 half = d.normal / std::hypot(d.normal.x, d.normal.y, d.normal.z) * (d.radius * 1e-3);
  const auto slab = [&](double height, double width) {
    return fmt::format("cylinder {{ {}, {}, {} }}", vector(half * -height), vector(half * height),
                       number(width * d.radius));
  };
  return {"intersection",
          fmt::format("disc {{ {} }} {} clipped_by {{ {} }}", primitive_of(d).body, slab(1, 2), slab(0.5, 1.5))};
}

Primitive primitive(const Triangle& triangle) {
  return primitive_of(triangle);
}

Primitive primitive(const Shapes& shapes, ShapeRef shape) {
  return shapes.visit(shape, [](const auto& s) { return primitive_of(s); });
}

} // namespace rt::tools::povray
