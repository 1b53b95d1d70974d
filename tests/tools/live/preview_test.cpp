#include "tools/live/preview.hpp"

#include <catch2/catch.hpp>

#include <condition_variable>
#include <mutex>
#include <vector>

using namespace rt;

namespace {

Film film_of(scene::Resolution size) {
  Film film;
  film.width = size[0];
  film.height = size[1];
  return film;
}

TEST_CASE("preview: a coarse picture comes first, then one of the whole size") {
  std::mutex mutex;
  std::condition_variable is_shown;
  std::vector<int> widths, heights;
  tools::live::Preview preview;
  preview.start(
      {10, 2}, [](scene::Resolution size, const std::atomic<bool>&) { return film_of(size); },
      [&](const Film& film) {
        const std::lock_guard lock(mutex);
        widths.push_back(film.width);
        heights.push_back(film.height);
        is_shown.notify_one();
      });
  std::unique_lock lock(mutex);
  REQUIRE(is_shown.wait_for(lock, std::chrono::seconds(5), [&] { return widths.size() == 2; }));
  CHECK(widths == std::vector{2, 10}); // a quarter, rounded down, but at least a pixel
  CHECK(heights == std::vector{1, 2});
}

TEST_CASE("preview: what is cancelled shows nothing any more") {
  std::atomic<bool> has_begun = false;
  std::atomic<int> shown = 0;
  tools::live::Preview preview;
  preview.start(
      {8, 8},
      [&](scene::Resolution size, const std::atomic<bool>& stop) -> std::optional<Film> {
        has_begun = true;
        while (!stop) std::this_thread::yield();
        return film_of(size);
      },
      [&](const Film&) { ++shown; });
  while (!has_begun) std::this_thread::yield();
  preview.cancel();
  CHECK(shown == 0);
}

} // namespace
