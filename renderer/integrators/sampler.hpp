#pragma once

#include "renderer/scene/scene.hpp"

namespace rt {

/// The pixel at column x and row y, from the top left.
struct PixelPosition {
  int x = 0, y = 0;
};

/// A number in [0, 1) for each pixel, sample and dimension. It depends on nothing else, so a picture is bit-identical
/// for any number of threads. Dimensions 0 and 1 are the position within the pixel, x and y.
///
/// This sampler is a regular grid in these two, the same in every pixel: row by row; a single sample is in the middle.
class Sampler {
public:
  /// `samples` must be a square number.
  explicit Sampler(int samples) : side_(scene::sample_grid(samples).value()) {}

  /// Per pixel.
  int samples() const { return side_ * side_; }

  double get(const PixelPosition& /*pixel*/, int sample, int dimension) const {
    return ((dimension == 0 ? sample % side_ : sample / side_) + 0.5) / side_;
  }

private:
  int side_;
};

} // namespace rt
