#include "renderer/shapes/cone.hpp"

#include "renderer/math/elementary.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/sampling/mappings.hpp"
#include "renderer/shapes/disc.hpp"

namespace rt::scene {

std::span<const Field> fields(const Cone*) {
  static constexpr Field table[] = {
      field<&Cone::from>("from", {"[0, 0, 0]", "centre of one end"}),
      field<&Cone::to>("to", {"[0, 1, 0]", "centre of the other end"}),
      field<&Cone::radius>("radius", {"1", "radius at `from`", not_negative}),
      field<&Cone::top_radius>("top_radius", {"0", "radius at `to`; 0 for a pointed cone", not_negative}),
      field<&Cone::open>("open", {"false", "true: without end discs"}),
  };
  return table;
}

std::optional<Problem> check(const Cone& cone) {
  if (cone.from == cone.to) return Problem{"to", "`from` and `to` are the same point: the cone has no length"};
  if (cone.radius == 0 && cone.top_radius == 0)
    return Problem{"radius", "`radius` and `top_radius` are both 0: the cone has no surface"};
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

ConeGeometry geometry(const scene::Cone& cone) {
  const Vec3 along = cone.to - cone.from;
  const double height = length(along);
  return {cone.from, normalize(along), height, cone.radius, cone.top_radius, (cone.top_radius - cone.radius) / height,
          cone.open};
}

std::optional<ConeGeometry> placed(const ConeGeometry& cone, const Affine& map) {
  const auto scale = similarity_scale(map);
  if (!scale) return std::nullopt;
  return ConeGeometry{map.point(cone.base), normalize(map.vector(cone.axis)), cone.height * *scale,
                      cone.radius * *scale, cone.top_radius * *scale,         cone.slope,
                      cone.is_open};
}

Box3 bounds(const ConeGeometry& cone, const Affine& map) {
  Box3 box = disc_bounds(map, cone.base, cone.axis, cone.radius);
  box.extend(disc_bounds(map, cone.base + cone.axis * cone.height, cone.axis, cone.top_radius));
  return box;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

AxisRange until(double t) {
  return {{-infinity, side_part}, {t, side_part}};
}
AxisRange from(double t) {
  return {{t, side_part}, {infinity, side_part}};
}

} // namespace

AxisRange side_span(const ConeGeometry& cone, const AxialRay& ray) {
  const Vec3 m = ray.origin_arm(), n = ray.direction_arm();
  const double radius = cone.radius + cone.slope * dot(ray.origin, ray.axis);
  const double widening = cone.slope * dot(ray.direction, ray.axis);
  const double a = dot(n, n) - widening * widening;
  const double b = dot(m, n) - radius * widening;
  const double c = dot(m, m) - radius * radius;
  const double aside = dot(ray.origin, n); // |m × n|, with a sign
  const Vec3 w = n * radius - m * widening;
  const bool is_near = 16 * std::abs(c) < radius * radius && 16 * b * b < radius * radius * dot(n, n);
  const double d = is_near || a == 0 ? b * b - a * c : dot(w, w) - aside * aside;
  if (a > 0 && c >= 0 && !(d >= 0)) return AxisRange::empty();
  if (a == 0 && b == 0) return c < 0 ? AxisRange{} : AxisRange::empty();
  const QuadraticRoots roots(a, b, c, std::max(d, 0.0));
  // Steeper than the side: a chord within one nappe.
  if (a > 0)
    return {{std::min(roots.first, roots.second), side_part}, {std::max(roots.first, roots.second), side_part}};
  // Parallel to a line of the side: inside from the single crossing on, or up to it.
  if (a == 0) return b > 0 ? until(roots.second) : from(roots.second);
  // Flatter: inside both nappes, beyond either crossing. The nappe that widens along the ray is entered, the other
  // left.
  return widening > 0 ? from(std::max(roots.first, roots.second)) : until(std::min(roots.first, roots.second));
}

// The side's point is the nearest one of the line segment that generates the side: in the half plane of distance from
// the axis and height, from (radius, 0) to (top_radius, height).
SurfacePoint surface_point(const ConeGeometry& cone, const Ray& ray, const Hit& hit) {
  const Vec3 from_base = relative_point(ray, hit, cone.base);
  const double along = dot(from_base, cone.axis);
  const double error = rounding_bound(32) * (magnitude(cone.base) + cone.height + cone.radius + cone.top_radius);
  if (hit.part != side_part) {
    const bool is_top = hit.part == top_part;
    const Vec3 position = from_base + cone.axis * ((is_top ? cone.height : 0) - along);
    return {cone.base + position, is_top ? cone.axis : -cone.axis, error};
  }
  const Vec3 outward = radial_direction(from_base, cone.axis);
  const double run = cone.top_radius - cone.radius;
  const double distance = dot(from_base, outward);
  const double share = ((distance - cone.radius) * run + along * cone.height) / (run * run + cone.height * cone.height);
  const double s = std::clamp(share, 0.0, 1.0);
  const Vec3 position = cone.axis * (s * cone.height) + outward * (cone.radius + s * run);
  return {cone.base + position, normalize(outward * cone.height - cone.axis * run), error};
}

Crossings crossings(const ConeGeometry& cone, const Ray& ray) {
  const AxialRay axial = axial_ray(cone, ray);
  return crossings_of(axial, inner_span(cone, axial));
}

bool contains(const ConeGeometry& cone, const Vec3& point) {
  const Vec3 from_base = point - cone.base;
  const double height = dot(from_base, cone.axis);
  const Vec3 arm = cross(from_base, cone.axis);
  const double radius = cone.radius + cone.slope * height;
  return height > 0 && height < cone.height && dot(arm, arm) < radius * radius;
}

double area(const ConeGeometry& cone) {
  const double run = cone.top_radius - cone.radius;
  const double slant = std::sqrt(run * run + cone.height * cone.height);
  return ends_area(cone.radius, cone.top_radius, cone.is_open) +
         std::numbers::pi * (cone.radius + cone.top_radius) * slant;
}

AreaPoint point_by_area(const ConeGeometry& cone, double u, double v) {
  double rest = u;
  if (const auto end = point_of_ends(cone, {cone.radius, cone.top_radius}, cone.is_open, rest, v)) return *end;
  // The area up to a height is proportional to the squared radius there.
  const double a = cone.radius * cone.radius, b = cone.top_radius * cone.top_radius;
  const double radius = std::sqrt(a + rest * (b - a)), run = cone.top_radius - cone.radius;
  const double share = rest * (cone.radius + cone.top_radius) / (radius + cone.radius);
  const SineCosine around = sine_cosine_of_turns(v);
  const Vec3 outward = TangentFrame(cone.axis).vector({around.cosine, around.sine, 0});
  return {cone.base + cone.axis * (share * cone.height) + outward * radius,
          normalize(outward * cone.height - cone.axis * run)};
}

} // namespace rt
