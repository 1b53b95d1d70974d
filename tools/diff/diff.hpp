#pragma once

#include "renderer/render/film.hpp"

#include <cstddef>
#include <optional>
#include <vector>

/// How much two pictures differ.
namespace rt::tools {

struct Difference {
  int width = 0, height = 0;
  /// Of linear colours, the largest of a pixel's three channels.
  std::vector<float> color_error;
  double color_max = 0;
  int color_max_x = 0, color_max_y = 0;
  std::size_t color_equal = 0;       ///< pixels within 1e-5
  std::size_t color_within_8bit = 0; ///< pixels whose sRGB values are within 1/255

  /// Of sRGB values from 0 to 1, as is usual for comparing pictures.
  double rmse = 0;
  double psnr = 0; ///< decibels; infinite for equal pictures
  double ssim = 1;

  /// If both pictures have layers.
  struct Layers {
    std::size_t other_object = 0;
    double depth_max = 0;  ///< relative, where both hit something
    double normal_max = 0; ///< radians
  };
  std::optional<Layers> layers;
};

/// Both must have the same size, at least one pixel.
Difference difference(const Film& a, const Film& b);

/// Mean structural similarity of two grey pictures with values from 0 to `range`, row by row: Z. Wang, A. C. Bovik, H.
/// R. Sheikh, E. P. Simoncelli, "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE
/// Transactions on Image Processing 13 (4), 2004. A Gaussian window of 11 × 11 with a standard deviation of 1.5, K₁ =
/// 0.01, K₂ = 0.03, at all positions where the window lies within the picture; in a smaller picture the window is as
/// large as fits.
double structural_similarity(const std::vector<double>& a, const std::vector<double>& b, int width, int height,
                             double range = 1);

} // namespace rt::tools
