#include "renderer/render/camera_rays.hpp"

#include "renderer/math/degrees.hpp"
#include "renderer/sampling/mappings.hpp"

namespace rt {

CameraRays::CameraRays(const scene::Camera& camera, scene::Resolution size)
    : origin_(camera.at), width_(size[0]), height_(size[1]),
      is_orthographic_(camera.projection == scene::Projection::orthographic),
      lens_radius_(camera.aperture.value_or(0) / 2), focus_distance_(scene::focus_distance(camera)) {
  forward_ = normalize(camera.look_at - camera.at);
  const Vec3 right = normalize(cross(forward_, camera.up));
  const Vec3 up = cross(right, forward_);
  // Half the width of the picture, at distance 1 or, if orthographic, in the scene itself.
  const double half_width = is_orthographic_ ? camera.width / 2 : tan_degrees(camera.fov / 2);
  right_ = right * half_width;
  down_ = up * (-half_width * height_ / width_);
  lens_right_ = right * lens_radius_;
  lens_down_ = up * -lens_radius_;
}

Ray CameraRays::lens_ray(double x, double y, double u, double v) const {
  const Ray middle = ray(x, y);
  if (!has_lens()) return middle;
  const Vec3 sharp = middle.at(focus_distance_ / dot(middle.direction, forward_));
  const Vec2 place = to_disc(u, v);
  const Vec3 from = middle.origin + lens_right_ * place.x + lens_down_ * place.y;
  return {from, normalize(sharp - from)};
}

} // namespace rt
