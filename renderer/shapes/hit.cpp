#include "renderer/shapes/hit.hpp"

#include "renderer/math/rounding.hpp"

namespace rt {

SurfacePoint mapped(const SurfacePoint& local, const Affine& to_scene, const Affine& to_local) {
  SurfacePoint image;
  image.position = to_scene.point(local.position);
  const Vec3 normal = to_local.transposed_vector(local.normal);
  const double scale = length(normal);
  image.normal = normal / scale;
  // A step s along the image's normal is a step of s·scale along the local one. It must outweigh the rounding of the
  // way out and of the way back, and the inverse's own: some times that of applying it.
  const double there_and_back = mapped_error(to_local, image.position, mapped_error(to_scene, local.position, 0));
  image.error = (local.error + 8 * there_and_back) / scale;
  return image;
}

} // namespace rt
