#pragma once

#include "renderer/integrators/ray_counts.hpp"
#include "renderer/render/render.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace rt {

/// What one thread does with the tiles assigned to it.
class TileWorker {
public:
  virtual ~TileWorker() = default;
  /// False if it was stopped before the tile was finished.
  virtual bool work(const PixelRect& tile) = 0;
  virtual const RayCounts& counts() const = 0;
};

/// Distributes the tiles of a picture to threads, once or several times, and reports progress.
class TileLoop {
public:
  using MakeWorker = std::function<std::unique_ptr<TileWorker>()>;

  /// `rect` is the part of the picture to work on. The options must outlive the loop.
  TileLoop(const PixelRect& rect, int threads, const RenderOptions& options);

  /// All tiles once, each by one worker. This run is the fraction from `begin` to `end` of the whole. False if it was
  /// stopped. Rethrows what a worker throws.
  bool run(const MakeWorker& make_worker, double begin, double end);

  /// Further values for progress reports.
  void tell(int samples, std::optional<double> noise);

  const RayCounts& counts() const { return counts_; }
  double seconds() const;
  int threads() const { return threads_; }

private:
  using Clock = std::chrono::steady_clock;

  void work(const MakeWorker& make_worker) noexcept;
  void take_tiles(TileWorker& worker);
  void watch();
  void report(std::unique_lock<std::mutex>& lock);
  bool is_stopped() const;
  PixelRect tile_rect(int tile) const;

  PixelRect rect_;
  int threads_;
  const RenderOptions& options_;
  int columns_, rows_;
  Clock::time_point start_ = Clock::now();
  double begin_ = 0, end_ = 1;
  int samples_ = 0;
  std::optional<double> noise_;
  std::atomic<int> next_tile_ = 0, finished_tiles_ = 0;
  std::atomic<std::uint64_t> rays_ = 0;
  std::atomic<bool> failed_ = false;

  std::mutex mutex_; // guards what follows
  std::condition_variable wake_;
  int finished_workers_ = 0;
  RayCounts counts_;
  std::exception_ptr error_;
};

} // namespace rt
