#pragma once

#include "renderer/render/film.hpp"
#include "tools/terminal/picture.hpp"

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace rt::tools {

/// Pictures made in the background while nothing is typed: first a coarse one, then finer ones in its place.
class Preview {
public:
  /// Makes the film of that size; nothing once `stop` is set.
  using MakeFilm = std::function<std::optional<Film>(scene::Resolution size, const std::atomic<bool>& stop)>;

  explicit Preview(const PicturePrinter& printer);
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Begins with the coarse one. What `make_film` reads must not change before `cancel`.
  void start(const PictureExtent& extent, MakeFilm make_film);
  /// Ends it, within the time of a tile.
  void cancel();

  /// Readable when there is a picture to be shown.
  int wake_fd() const { return wake_fd_; }
  /// The newest picture, with what moves the cursor up over the one before it.
  std::string take();

private:
  void work(const PictureExtent& extent, const MakeFilm& make_film);
  void drain() const;

  const PicturePrinter& printer_;
  int wake_fd_;
  std::atomic<bool> stop_ = false;
  std::thread worker_;
  std::mutex mutex_; // guards what follows
  std::string ready_;
  int ready_rows_ = 0;
  int shown_rows_ = 0; // of the picture that stands above the prompt
};

} // namespace rt::tools
