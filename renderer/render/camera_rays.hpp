#pragma once

#include "renderer/integrators/sampler.hpp"
#include "renderer/math/ray.hpp"
#include "renderer/scene/camera.hpp"

namespace rt {

/// The rays of a camera for a picture of one resolution.
class CameraRays {
public:
  /// `camera` must have passed validation: it has a view direction that is not along `up`.
  CameraRays(const scene::Camera& camera, scene::Resolution size);

  /// The ray through a point of the picture in continuous pixel coordinates: (0, 0) is the top left corner, and the
  /// pixel (i, j) has its centre at (i + ½, j + ½). The direction is a unit vector.
  Ray ray(double x, double y) const {
    const Vec3 across = right_ * (2 * x / width_ - 1) + down_ * (2 * y / height_ - 1);
    if (is_orthographic_) return {origin_ + across, forward_};
    return {origin_, normalize(forward_ + across)};
  }

  /// The ray of one of a pixel's samples.
  Ray ray(const PixelPosition& pixel, const Sampler& sampler, int sample) const {
    return ray(pixel.x + sampler.get(pixel, sample, 0), pixel.y + sampler.get(pixel, sample, 1));
  }

  /// The ray through that point of the picture and a point of the lens, for uniform u and v: all of them meet in the
  /// plane of focus. Without a lens it is the single ray.
  Ray lens_ray(double x, double y, double u, double v) const;
  bool has_lens() const { return lens_radius_ > 0; }

  /// Whether all rays from `ray` start at the same point.
  bool has_one_eye() const { return !is_orthographic_; }

private:
  Vec3 origin_;
  Vec3 forward_, right_, down_; // right_ and down_ reach from the picture's centre to its edges
  double width_, height_;
  bool is_orthographic_;
  double lens_radius_, focus_distance_;
  Vec3 lens_right_, lens_down_; // as long as the lens's radius
};

} // namespace rt
