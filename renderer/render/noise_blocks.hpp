#pragma once

#include "renderer/render/film.hpp"
#include "renderer/render/sums.hpp"

#include <span>
#include <vector>

namespace rt {

/// The noise of a picture during rendering, in blocks of 16 × 16 pixels (aligned to the whole picture), and which of
/// them need more samples.
///
/// A block's noise is the root mean square sampling error of the finished picture, as a fraction of full scale: the
/// mean over its pixels and channels of (w·(A − B)/2)², A and B being the halves of the samples and w the slope of
/// sRGB's encoding at the mean light of the 3 × 3 pixels around; above 1, where light is clipped, that of the logarithm
/// scaled to be as steep at 1.
class NoiseBlocks {
public:
  /// `rect` is the part of the picture being rendered. A block is finished once it and its neighbours have been below
  /// `aim` after two consecutive passes; with an aim of 0 none ever is.
  NoiseBlocks(const PixelRect& rect, double aim);

  /// To be called after a pass over all unfinished blocks: `sums` are the pixels'.
  void update(std::span<const PixelSums> sums);

  /// What a picture must store about a pixel's block so that rendering can resume as if it had never stopped; and the
  /// reverse, from all pixels of the part.
  std::uint32_t state(int x, int y) const;
  void restore(std::span<const std::uint32_t> states, std::span<const PixelSums> sums);

  bool rests(int x, int y) const { return rests_[index(x / side, y / side)]; }
  bool all_rest() const;
  /// That of the noisiest block; infinite before there are two samples per pixel.
  double worst() const;

private:
  static constexpr int side = 16;

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column - first_column_);
  }
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y - rect_.y0) * static_cast<std::size_t>(rect_.width()) +
           static_cast<std::size_t>(x - rect_.x0);
  }
  void settle();
  double noise(int column, int row, std::span<const PixelSums> sums, std::span<const Color> means) const;
  Color light_around(int x, int y, std::span<const Color> means) const;
  bool is_surrounded_by_calm(int column, int row) const;

  PixelRect rect_;
  double aim_;
  int first_column_, first_row_, columns_, rows_;
  std::vector<double> noise_; // by block
  std::vector<int> calm_;     // for how many passes it has been below the aim
  std::vector<bool> rests_;
};

} // namespace rt
