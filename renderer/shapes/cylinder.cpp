#include "renderer/shapes/cylinder.hpp"

#include "renderer/math/elementary.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/sampling/mappings.hpp"
#include "renderer/shapes/disc.hpp"

namespace rt::scene {

std::span<const Field> fields(const Cylinder*) {
  static constexpr Field table[] = {
      field<&Cylinder::from>("from", {"", "centre of one end", any_value, 1}),
      field<&Cylinder::to>("to", {"", "centre of the other end", any_value, 1}),
      field<&Cylinder::axis>("axis", {"[0, 1, 0]", "direction of the axis; the centre is at `at`", nonzero, 2}),
      field<&Cylinder::height>("height", {"1", "length from end to end, half of it each way", positive, 2}),
      field<&Cylinder::radius>("radius", {"1", "distance from the axis to the surface", positive}),
      field<&Cylinder::open>("open", {"false", "true: an open tube, without end discs"}),
      field<&Cylinder::infinite>("infinite", {"false", "true: extends infinitely along its axis in both directions"}),
  };
  return table;
}

std::optional<Problem> check(const Cylinder& cylinder) {
  if (cylinder.from && !cylinder.to)
    return Problem{"from", "a cylinder with `from` needs `to`, the centre of its other end"};
  if (cylinder.to && !cylinder.from)
    return Problem{"to", "a cylinder with `to` needs `from`, the centre of its other end"};
  if (cylinder.from && *cylinder.from == *cylinder.to)
    return Problem{"to", "`from` and `to` are the same point: the cylinder has no length"};
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

CylinderGeometry geometry(const scene::Cylinder& cylinder) {
  using Extent = CylinderGeometry::Extent;
  const Extent extent = cylinder.infinite ? Extent::infinite : cylinder.open ? Extent::open : Extent::closed;
  if (cylinder.from) {
    const Vec3 along = *cylinder.to - *cylinder.from;
    return {*cylinder.from, normalize(along), length(along), cylinder.radius, extent};
  }
  const Vec3 axis = normalize(cylinder.axis.value_or(Vec3{0, 1, 0}));
  const double height = cylinder.height.value_or(1);
  return {axis * (-height / 2), axis, height, cylinder.radius, extent};
}

std::optional<CylinderGeometry> placed(const CylinderGeometry& cylinder, const Affine& map) {
  const auto scale = similarity_scale(map);
  if (!scale) return std::nullopt;
  return CylinderGeometry{map.point(cylinder.base), normalize(map.vector(cylinder.axis)), cylinder.height * *scale,
                          cylinder.radius * *scale, cylinder.extent};
}

Box3 bounds(const CylinderGeometry& cylinder, const Affine& map) {
  Box3 box = disc_bounds(map, cylinder.base, cylinder.axis, cylinder.radius);
  if (cylinder.extent != CylinderGeometry::Extent::infinite) {
    box.extend(disc_bounds(map, cylinder.base + cylinder.axis * cylinder.height, cylinder.axis, cylinder.radius));
    return box;
  }
  const Vec3 along = map.vector(cylinder.axis);
  const Box3 everywhere = all_space();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (along[axis] != 0) box.lower[axis] = everywhere.lower[axis], box.upper[axis] = everywhere.upper[axis];
  }
  return box;
}

SurfacePoint surface_point(const CylinderGeometry& cylinder, const Ray& ray, const Hit& hit) {
  const Vec3 from_base = relative_point(ray, hit, cylinder.base);
  const double along = dot(from_base, cylinder.axis);
  const bool is_infinite = cylinder.extent == CylinderGeometry::Extent::infinite;
  const double size = cylinder.radius + (is_infinite ? std::abs(along) : cylinder.height);
  const double error = rounding_bound(32) * (magnitude(cylinder.base) + size);
  if (hit.part == side_part) {
    const Vec3 normal = radial_direction(from_base, cylinder.axis);
    const double height = is_infinite ? along : std::clamp(along, 0.0, cylinder.height);
    return {cylinder.base + cylinder.axis * height + normal * cylinder.radius, normal, error};
  }
  const bool is_top = hit.part == top_part;
  const Vec3 position = from_base + cylinder.axis * ((is_top ? cylinder.height : 0) - along);
  return {cylinder.base + position, is_top ? cylinder.axis : -cylinder.axis, error};
}

Crossings crossings(const CylinderGeometry& cylinder, const Ray& ray) {
  const AxialRay axial = axial_ray(cylinder, ray);
  return crossings_of(axial, inner_span(cylinder, axial));
}

bool contains(const CylinderGeometry& cylinder, const Vec3& point) {
  const Vec3 from_base = point - cylinder.base;
  const double height = dot(from_base, cylinder.axis);
  const Vec3 arm = cross(from_base, cylinder.axis);
  if (dot(arm, arm) >= cylinder.radius * cylinder.radius) return false;
  return cylinder.extent == CylinderGeometry::Extent::infinite || (height > 0 && height < cylinder.height);
}

double area(const CylinderGeometry& cylinder) {
  if (cylinder.extent == CylinderGeometry::Extent::infinite) return std::numeric_limits<double>::infinity();
  return ends_area(cylinder.radius, cylinder.radius, !is_solid(cylinder)) +
         2 * std::numbers::pi * cylinder.radius * cylinder.height;
}

AreaPoint point_by_area(const CylinderGeometry& cylinder, double u, double v) {
  double rest = u;
  if (const auto end = point_of_ends(cylinder, {cylinder.radius, cylinder.radius}, !is_solid(cylinder), rest, v))
    return *end;
  const SineCosine around = sine_cosine_of_turns(v);
  const Vec3 outward = TangentFrame(cylinder.axis).vector({around.cosine, around.sine, 0});
  return {cylinder.base + cylinder.axis * (rest * cylinder.height) + outward * cylinder.radius, outward};
}

} // namespace rt
