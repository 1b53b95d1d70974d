#include "renderer/shapes/disc.hpp"

#include "renderer/math/rounding.hpp"
#include "renderer/sampling/mappings.hpp"

#include <cmath>
#include <numbers>

namespace rt::scene {

std::span<const Field> fields(const Disc*) {
  static constexpr Field table[] = {
      field<&Disc::normal>("normal", {"[0, 1, 0]", "direction perpendicular to the disc", nonzero}),
      field<&Disc::radius>("radius", {"1", "distance from the centre to the rim", positive}),
      field<&Disc::hole>("hole", {"0", "radius of the round hole in the middle", not_negative}),
  };
  return table;
}

std::optional<Problem> check(const Disc& disc) {
  if (disc.hole > disc.radius) return Problem{"hole", "`hole` is larger than `radius`: the disc is empty"};
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

DiscGeometry geometry(const scene::Disc& disc) {
  return {{}, normalize(disc.normal), disc.radius, disc.hole};
}

std::optional<DiscGeometry> placed(const DiscGeometry& disc, const Affine& map) {
  const auto scale = similarity_scale(map);
  if (!scale) return std::nullopt;
  return DiscGeometry{map.point(disc.center), normalize(map.normal(disc.normal)), disc.radius * *scale,
                      disc.hole * *scale};
}

// With u, v spanning the disc's plane, the image extends radius·√((row·u)² + (row·v)²) along each axis: the length of
// the row's part perpendicular to the normal.
Box3 disc_bounds(const Affine& map, const Vec3& center, const Vec3& normal, double radius) {
  const Vec3 middle = map.point(center);
  Vec3 reach;
  for (std::size_t axis = 0; axis < 3; ++axis) reach[axis] = length(reject(map.row(axis), normal)) * radius;
  return {middle - reach, middle + reach};
}

Box3 bounds(const DiscGeometry& disc, const Affine& map) {
  return disc_bounds(map, disc.center, disc.normal, disc.radius);
}

SurfacePoint surface_point(const DiscGeometry& disc, const Ray& ray, const Hit& hit) {
  const Vec3 from_center = reject(relative_point(ray, hit, disc.center), disc.normal);
  return {disc.center + from_center, disc.normal, rounding_bound(16) * (magnitude(disc.center) + disc.radius)};
}

double area(const DiscGeometry& disc) {
  return std::numbers::pi * (disc.radius * disc.radius - disc.hole * disc.hole);
}

// Rings of the whole disc, moved outwards to leave the hole.
AreaPoint point_by_area(const DiscGeometry& disc, double u, double v) {
  const Vec2 d = to_disc(u, v);
  const double r2 = disc.radius * disc.radius, hole2 = disc.hole * disc.hole, whole = d.x * d.x + d.y * d.y;
  const double stretch = hole2 == 0 ? disc.radius : std::sqrt((hole2 + (r2 - hole2) * whole) / whole);
  return {disc.center + TangentFrame(disc.normal).vector({d.x * stretch, d.y * stretch, 0}), disc.normal};
}

} // namespace rt
