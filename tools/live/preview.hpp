#pragma once

#include "renderer/render/film.hpp"
#include "renderer/scene/scene.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

namespace rt::tools::live {

/// Pictures made in the background: first a coarse one, then finer ones in its place.
class Preview {
public:
  /// Makes the film of that size; nothing once `stop` is set.
  using MakeFilm = std::function<std::optional<Film>(scene::Resolution size, const std::atomic<bool>& stop)>;
  /// Takes each film as it is ready, in the background's thread.
  using Show = std::function<void(const Film& film)>;

  Preview() = default;
  ~Preview() { cancel(); }
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// In place of what was started before. What the two functions read must not change before `cancel`.
  void start(scene::Resolution size, MakeFilm make_film, Show show);
  /// Ends it, within the time of a tile.
  void cancel();

private:
  void work(scene::Resolution size, const MakeFilm& make_film, const Show& show) const;

  std::atomic<bool> stop_ = false;
  std::thread worker_;
};

} // namespace rt::tools::live
