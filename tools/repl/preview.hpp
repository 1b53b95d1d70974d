#pragma once

#include "tools/live/preview.hpp"
#include "tools/terminal/picture.hpp"

#include <mutex>
#include <string>

namespace rt::tools {

/// Previews as a terminal shows them, rendered while nothing is typed: each replaces the one before.
class PreviewPrinter {
public:
  explicit PreviewPrinter(const PicturePrinter& printer);
  ~PreviewPrinter();
  PreviewPrinter(const PreviewPrinter&) = delete;
  PreviewPrinter& operator=(const PreviewPrinter&) = delete;

  /// Starts with the coarse one. What `make_film` reads must not change before `cancel`.
  void start(const PictureExtent& extent, live::Preview::MakeFilm make_film);
  /// Stops it, within the time of a tile.
  void cancel();

  /// Readable when there is a picture to show.
  int wake_fd() const { return wake_fd_; }
  /// The newest picture, preceded by moving the cursor up over the previous one.
  std::string take();

private:
  void show(const PictureExtent& extent, const Film& film);
  void drain() const;

  const PicturePrinter& printer_;
  int wake_fd_;
  std::mutex mutex_; // guards what follows
  std::string ready_;
  int ready_rows_ = 0;
  int shown_rows_ = 0;    // of the picture above the prompt
  live::Preview preview_; // last: its thread uses the rest
};

} // namespace rt::tools
