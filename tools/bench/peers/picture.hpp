#pragma once

#include <string>
#include <vector>

namespace rt::tools::bench {

/// Linear RGB, rows from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<float> values; // r, g, b of each pixel
};

enum class Encoding { linear, srgb };

/// From a PNG file with 8 bits, whose values are interpreted by `encoding`, whatever its chunks say. Throws
/// std::runtime_error.
Picture read_png(const std::string& path, Encoding encoding);

/// From a binary PPM file with 8 bits and linear values.
Picture read_ppm(const std::string& path);

/// The fraction of pixels in which a channel differs by more than `steps` of 255.
double share_that_differs(const Picture& a, const Picture& b, double steps);

} // namespace rt::tools::bench
