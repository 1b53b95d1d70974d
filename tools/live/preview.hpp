#pragma once

#include "renderer/render/film.hpp"
#include "renderer/scene/scene.hpp"

#include <atomic>
#include <functional>
#include <optional>
#include <thread>

namespace rt::tools::live {

/// Pictures rendered in the background: first a coarse one, then finer ones that replace it.
class Preview {
public:
  /// Renders the film at that size; nothing once `stop` is set.
  using MakeFilm = std::function<std::optional<Film>(scene::Resolution size, const std::atomic<bool>& stop)>;
  /// Takes each film as it is finished, in the background thread.
  using Show = std::function<void(const Film& film)>;

  Preview() = default;
  ~Preview() { cancel(); }
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Replaces what was started before. What the two functions read must not change before `cancel`.
  void start(scene::Resolution size, MakeFilm make_film, Show show);
  /// Stops it, within the time of a tile.
  void cancel();

private:
  void work(scene::Resolution size, const MakeFilm& make_film, const Show& show) const;

  std::atomic<bool> stop_ = false;
  std::thread worker_;
};

} // namespace rt::tools::live
