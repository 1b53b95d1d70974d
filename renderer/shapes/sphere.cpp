#include "renderer/shapes/sphere.hpp"

#include "renderer/sampling/mappings.hpp"

#include <numbers>

namespace rt::scene {

std::span<const Field> fields(const Sphere*) {
  static constexpr Field table[] = {
      field<&Sphere::radius>("radius", {"1", "distance from the centre to the surface", positive}),
  };
  return table;
}

std::optional<Problem> check(const Sphere&) {
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

SphereGeometry geometry(const scene::Sphere& sphere) {
  return {{}, sphere.radius};
}

std::optional<SphereGeometry> placed(const SphereGeometry& sphere, const Affine& map) {
  const auto scale = similarity_scale(map);
  if (!scale) return std::nullopt;
  return SphereGeometry{map.point(sphere.center), sphere.radius * *scale};
}

// The image of a sphere is an ellipsoid; along each axis its extent is the length of the map's row.
Box3 bounds(const SphereGeometry& sphere, const Affine& map) {
  const Vec3 reach = Vec3{length(map.row(0)), length(map.row(1)), length(map.row(2))} * sphere.radius;
  const Vec3 center = map.point(sphere.center);
  return {center - reach, center + reach};
}

Crossings crossings(const SphereGeometry& sphere, const Ray& ray) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double power = dot(to_center, to_center) - sphere.radius * sphere.radius;
  const SphereChord chord = sphere_chord(to_center, power, ray.direction, sphere.radius);
  Crossings found;
  if (!(chord.half_squared > 0)) return found;
  Hit enter, leave;
  chord.roots(enter.t, leave.t);
  if (enter.t < leave.t) found.add(enter, leave);
  return found;
}

bool contains(const SphereGeometry& sphere, const Vec3& point) {
  const Vec3 v = point - sphere.center;
  return dot(v, v) < sphere.radius * sphere.radius;
}

double area(const SphereGeometry& sphere) {
  return 4 * std::numbers::pi * sphere.radius * sphere.radius;
}

AreaPoint point_by_area(const SphereGeometry& sphere, double u, double v) {
  const Vec3 normal = to_sphere(u, v);
  return {sphere.center + normal * sphere.radius, normal};
}

} // namespace rt
