#include "renderer/render/camera_rays.hpp"

#include "renderer/math/degrees.hpp"

namespace rt {

CameraRays::CameraRays(const scene::Camera& camera, scene::Resolution size)
    : origin_(camera.at), width_(size[0]), height_(size[1]),
      is_orthographic_(camera.projection == scene::Projection::orthographic) {
  forward_ = normalize(camera.look_at - camera.at);
  const Vec3 right = normalize(cross(forward_, camera.up));
  const Vec3 up = cross(right, forward_);
  // Half the width of the picture, at distance 1 or, without perspective, in the scene itself.
  const double half_width = is_orthographic_ ? camera.width / 2 : tan_degrees(camera.fov / 2);
  right_ = right * half_width;
  down_ = up * (-half_width * height_ / width_);
}

} // namespace rt
