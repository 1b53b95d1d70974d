#pragma once

#include "renderer/math/ray.hpp"
#include "renderer/scene/camera.hpp"

namespace rt {

/// The rays of a camera for a picture of one size.
class CameraRays {
public:
  /// `camera` must have passed its check: it looks somewhere, and not along `up`.
  CameraRays(const scene::Camera& camera, scene::Resolution size);

  /// The ray through a point of the picture in continuous pixel coordinates: (0, 0) is the top left corner, and the
  /// pixel (i, j) has its centre at (i + ½, j + ½). The direction is a unit vector.
  Ray ray(double x, double y) const {
    const Vec3 across = right_ * (2 * x / width_ - 1) + down_ * (2 * y / height_ - 1);
    if (is_orthographic_) return {origin_ + across, forward_};
    return {origin_, normalize(forward_ + across)};
  }

  /// The place of one sample within a pixel: of an n × n grid, the `sample`-th row by row; 0 of 1 is the pixel's
  /// centre.
  struct Place {
    double x, y;
    Place(int sample, int n) : x((sample % n + 0.5) / n), y((sample / n + 0.5) / n) {}
  };
  Ray ray(int pixel_x, int pixel_y, const Place& place) const { return ray(pixel_x + place.x, pixel_y + place.y); }
  Ray ray(int pixel_x, int pixel_y, int sample, int n) const { return ray(pixel_x, pixel_y, Place(sample, n)); }

  /// Whether all rays start at the same point.
  bool has_one_eye() const { return !is_orthographic_; }

private:
  Vec3 origin_;
  Vec3 forward_, right_, down_; // right_ and down_ reach from the picture's middle to its edges
  double width_, height_;
  bool is_orthographic_;
};

} // namespace rt
