#include "renderer/shapes/hit.hpp"

#include "renderer/math/rounding.hpp"

#include <algorithm>

namespace rt {

bool touch(const SurfacePoint& a, const SurfacePoint& b) {
  const Vec3 between = b.position - a.position;
  return std::max(std::abs(dot(between, a.normal)), std::abs(dot(between, b.normal))) <= a.error + b.error;
}

SurfacePoint mapped(const SurfacePoint& local, const Affine& to_scene, const Affine& to_local) {
  SurfacePoint image;
  image.position = to_scene.point(local.position);
  const Vec3 normal = to_local.transposed_vector(local.normal);
  const double scale = length(normal);
  image.normal = normal / scale;
  // A step s along the image's normal is a step of s·scale along the local one. It must outweigh how far the inverse
  // map misses the point, because the maps are inverses only up to rounding, and the rounding of both.
  const double missed = length(to_local.point(image.position) - local.position);
  const double rounding = mapped_error(to_local, image.position, mapped_error(to_scene, local.position, 0));
  image.error = (local.error + missed + 2 * rounding) / scale;
  return image;
}

} // namespace rt
