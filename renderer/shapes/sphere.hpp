#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The points at `radius` from the origin of object space (its `at` is part of the placement).
struct Sphere {
  static constexpr std::string_view noun = "sphere";
  static constexpr std::string_view help = "a sphere around its centre";
  double radius = 1;
};

std::span<const Field> fields(const Sphere*);
std::optional<Problem> check(const Sphere&);

} // namespace rt::scene

namespace rt {

struct SphereGeometry {
  Vec3 center;
  double radius = 1;
};

SphereGeometry geometry(const scene::Sphere& sphere);
std::optional<SphereGeometry> placed(const SphereGeometry& sphere, const Affine& map);
Box3 bounds(const SphereGeometry& sphere, const Affine& map);
inline Box3 bounds(const SphereGeometry& sphere) {
  const Vec3 reach{sphere.radius, sphere.radius, sphere.radius};
  return {sphere.center - reach, sphere.center + reach};
}

inline SurfacePoint surface_point(const SphereGeometry& sphere, const Ray& ray, const Hit& hit) {
  const Vec3 normal = normalize(relative_point(ray, hit, sphere.center));
  return {sphere.center + normal * sphere.radius, normal,
          rounding_bound(32) * (magnitude(sphere.center) + sphere.radius)};
}
Crossings crossings(const SphereGeometry& sphere, const Ray& ray);
bool contains(const SphereGeometry& sphere, const Vec3& point);
constexpr bool is_solid(const SphereGeometry&) {
  return true;
}

inline const SphereGeometry& lamp_surface(const SphereGeometry& sphere) {
  return sphere;
}
double area(const SphereGeometry& sphere);
AreaPoint point_by_area(const SphereGeometry& sphere, double u, double v);

/// The line's segment inside the sphere is a chord about the point nearest to the centre. Half its length follows from
/// that point's distance, which stays accurate for far origins (Haines, Günther and Akenine-Möller, Precision
/// Improvements for Ray/Sphere Intersection, Ray Tracing Gems, 2019); the root that would cancel follows from the
/// product of both.
struct SphereChord {
  double middle;       ///< t of the point nearest to the centre
  double half_squared; ///< negative: the line misses
  double product;      ///< of both roots: positive if the origin is outside

  /// Both roots in order; half_squared must not be negative.
  void roots(double& near, double& far) const {
    const double half = std::sqrt(half_squared);
    if (middle >= 0)
      far = middle + half, near = product / far;
    else
      near = middle - half, far = product / near;
  }
};

/// `power` is |to_center|² − radius².
inline SphereChord sphere_chord(const Vec3& to_center, double power, const Vec3& direction, double radius) {
  const double inverse = 1 / dot(direction, direction);
  const double middle = dot(to_center, direction) * inverse;
  const Vec3 aside = to_center - direction * middle;
  return {middle, (radius * radius - dot(aside, aside)) * inverse, power * inverse};
}

inline bool intersect(const SphereGeometry& sphere, const Ray& ray, const Interval& range, Hit& hit) {
  const Vec3 to_center = sphere.center - ray.origin;
  const double power = dot(to_center, to_center) - sphere.radius * sphere.radius;
  if (power > 0 && dot(to_center, ray.direction) <= 0) return false; // outside and moving away
  const SphereChord chord = sphere_chord(to_center, power, ray.direction, sphere.radius);
  if (!(chord.half_squared >= 0)) return false;
  Hit near, far;
  chord.roots(near.t, far.t);
  return take_first(near, far, range, hit);
}

} // namespace rt
