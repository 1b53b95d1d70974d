#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/tone_mapping.hpp"
#include "renderer/math/vec3.hpp"
#include "renderer/render/sums.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rt {

/// A half-open rectangle of pixels, x to the right, y down from the top.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  constexpr int width() const { return x1 - x0; }
  constexpr int height() const { return y1 - y0; }
  friend constexpr bool operator==(const PixelRect&, const PixelRect&) = default;
};

struct Rgb32 {
  float r = 0, g = 0, b = 0;
};
struct Xyz32 {
  float x = 0, y = 0, z = 0;
};

/// A finished picture: the linear colour of every pixel, row by row from the top left. If layers were requested they
/// hold the first hit of the pixel's centre ray; otherwise they are empty.
struct Film {
  int width = 0, height = 0;
  std::vector<Rgb32> color;

  std::vector<double> depth;            ///< Euclidean distance from the ray's origin; infinite for a miss
  std::vector<Xyz32> normal;            ///< unit, in scene space, facing the viewer; zero for a miss
  std::vector<Xyz32> position;          ///< in scene space; zero for a miss
  std::vector<std::uint32_t> object_id; ///< from 1 in order of declaration; 0 for a miss
  std::vector<Rgb32> albedo;            ///< the surface's colour, pattern evaluated

  std::vector<Rgb32> error; ///< with random samples: the standard error of the colour, estimated for each pixel
  std::vector<std::uint32_t> samples;      ///< and how many there were
  std::vector<PixelSums> sums;             ///< what further samples can be added to, if requested
  std::vector<std::uint32_t> noise_states; ///< and what `NoiseBlocks` needs to continue

  ToneMapping tone_mapping; ///< how it is to be shown; all colours here are linear light

  /// Its place in the whole picture, which may be larger: its upper left corner, and the picture's size.
  int left = 0, top = 0;
  int picture_width = 0, picture_height = 0; ///< 0: the film is the whole picture

  bool has_layers() const { return !depth.empty(); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// The memory that the pixels of a film take.
constexpr std::uint64_t film_bytes(const PixelRect& rect, bool layers) {
  constexpr std::uint64_t color = sizeof(Rgb32);
  constexpr std::uint64_t further = sizeof(double) + 2 * sizeof(Xyz32) + sizeof(std::uint32_t) + sizeof(Rgb32);
  return static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height()) *
         (color + (layers ? further : 0));
}

} // namespace rt
