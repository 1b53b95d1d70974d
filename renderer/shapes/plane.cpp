#include "renderer/shapes/plane.hpp"

#include "renderer/math/rounding.hpp"

namespace rt::scene {

std::span<const Field> fields(const Plane*) {
  static constexpr Field table[] = {
      field<&Plane::normal>(
          "normal", {"[0, 1, 0]", "direction perpendicular to the plane, away from its solid side", nonzero, 1}),
      field<&Plane::offset>("offset", {"0", "distance of the plane from the origin along `normal`", any_value, 1}),
      field<&Plane::x>("x", {"", "the plane of this x, facing +x", any_value, 2}),
      field<&Plane::y>("y", {"", "the plane of this y, facing +y", any_value, 3}),
      field<&Plane::z>("z", {"", "the plane of this z, facing +z", any_value, 4}),
  };
  return table;
}

std::optional<Problem> check(const Plane&) {
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

PlaneGeometry geometry(const scene::Plane& plane) {
  if (plane.x) return {{1, 0, 0}, *plane.x};
  if (plane.y) return {{0, 1, 0}, *plane.y};
  if (plane.z) return {{0, 0, 1}, *plane.z};
  return {normalize(plane.normal.value_or(Vec3{0, 1, 0})), plane.offset.value_or(0)};
}

std::optional<PlaneGeometry> placed(const PlaneGeometry& plane, const Affine& map) {
  const auto back = inverse(map);
  if (!back) return std::nullopt;
  // n·(M⁻¹ p + b) = offset, so M⁻ᵀ n · p = offset − n·b.
  const Vec3 normal = back->transposed_vector(plane.normal);
  const double scale = length(normal);
  return PlaneGeometry{normal / scale, (plane.offset - dot(plane.normal, back->translation)) / scale};
}

Box3 bounds(const PlaneGeometry& plane, const Affine& map) {
  Box3 box = all_space();
  const auto image = placed(plane, map);
  if (!image) return box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (image->normal[axis] == 1) box.upper[axis] = image->offset;
    if (image->normal[axis] == -1) box.lower[axis] = -image->offset;
  }
  return box;
}

// What matters is how far the rounding error of a point's distance from the plane reaches: that is a sum of products of
// the coordinates with the normal's.
SurfacePoint surface_point(const PlaneGeometry& plane, const Ray& ray, const Hit& hit) {
  const Vec3 p = ray.at(hit.t);
  const Vec3 position = p - plane.normal * (dot(plane.normal, p) - plane.offset);
  const double distance_terms = magnitude(multiply(plane.normal, position)) + std::abs(plane.offset);
  return {position, plane.normal,
          rounding_bound(16) * distance_terms + rounding_bound(2) * magnitude(position) +
              std::numeric_limits<double>::min()};
}

Crossings crossings(const PlaneGeometry& plane, const Ray& ray) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double approach = dot(plane.normal, ray.direction);
  const double t = (plane.offset - dot(plane.normal, ray.origin)) / approach;
  Crossings found;
  if (approach < 0)
    found.add({t, 0}, {infinity, 0});
  else if (approach > 0)
    found.add({-infinity, 0}, {t, 0});
  else if (contains(plane, ray.origin))
    found.add({-infinity, 0}, {infinity, 0});
  return found;
}

bool contains(const PlaneGeometry& plane, const Vec3& point) {
  return dot(plane.normal, point) < plane.offset;
}

} // namespace rt
