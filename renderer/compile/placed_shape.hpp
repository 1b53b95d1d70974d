#pragma once

#include "renderer/math/affine.hpp"
#include "renderer/shapes/hit.hpp"

#include <concepts>

/// The two ways to place a shape in a space: as a geometry of that space, or in object space with a map.
namespace rt {

/// A geometry that has an inside.
template <class G>
concept Solidlike = requires(const G& g, const Ray& ray, const Vec3& p) {
  { *crossings(g, ray).begin() } -> std::convertible_to<const Hit&>;
  { contains(g, p) } -> std::same_as<bool>;
};

/// Most shapes: the transform is applied to the geometry.
template <class Geometry>
struct Baked {
  using G = Geometry;
  G shape;

  Box3 box() const { return bounds(shape); }
  Box3 box(const Affine& map) const { return bounds(shape, map); }
  const Ray& carried(const Ray& ray) const { return ray; }
  const Vec3& carried(const Vec3& p) const { return p; }
  SurfacePoint point(const Ray& ray, const Hit& hit) const { return surface_point(shape, ray, hit); }
};

/// A shape that the transform turns into something else, such as an ellipsoid from a sphere: rays are transformed to
/// object space, where t is unchanged because the transformed direction is not normalised.
template <class Geometry>
struct Transformed {
  using G = Geometry;
  G shape;
  Affine to_outer, to_local;

  Box3 box() const { return bounds(shape, to_outer); }
  Box3 box(const Affine& map) const { return bounds(shape, map * to_outer); }
  Ray carried(const Ray& ray) const { return to_local.ray(ray); }
  Vec3 carried(const Vec3& p) const { return to_local.point(p); }
  SurfacePoint point(const Ray& ray, const Hit& hit) const {
    return mapped(surface_point(shape, carried(ray), hit), to_outer, to_local);
  }
};

} // namespace rt
