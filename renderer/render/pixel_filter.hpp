#pragma once

#include "renderer/render/camera_rays.hpp"
#include "renderer/sampling/sobol.hpp"
#include "renderer/scene/scene.hpp"

#include <vector>

namespace rt {

/// A pixel filter as a density from which sample positions are drawn: every sample then has equal weight and belongs to
/// one pixel (M. Ernst, M. Stamminger, G. Greiner, Filter Importance Sampling, 2006).
class FilterSampler {
public:
  explicit FilterSampler(scene::PixelFilter filter);

  /// The distance from the pixel's centre along one axis, in pixels, for a `u` uniform in 0 to 1.
  double offset(double u) const;

private:
  // The density is piecewise linear between equidistant points.
  double radius_;
  std::vector<double> density_, cumulative_;
};

/// The camera's ray for a sample of a pixel.
inline Ray sample_ray(const CameraRays& camera, const FilterSampler& filter, const SampleStream& stream, int x, int y) {
  const auto place = stream.group(camera_group);
  const double u = x + 0.5 + filter.offset(place[0]), v = y + 0.5 + filter.offset(place[1]);
  if (!camera.has_lens()) return camera.ray(u, v);
  const auto lens = stream.group(lens_group);
  return camera.lens_ray(u, v, lens[0], lens[1]);
}

} // namespace rt
