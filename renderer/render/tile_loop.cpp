#include "renderer/render/tile_loop.hpp"

#include <algorithm>
#include <thread>
#include <vector>

namespace rt {
namespace {

constexpr int tile_side = 16;
constexpr std::chrono::milliseconds progress_interval{100};

} // namespace

TileLoop::TileLoop(const PixelRect& rect, int threads, const RenderOptions& options)
    : rect_(rect), threads_(threads), options_(options), columns_((rect.width() + tile_side - 1) / tile_side),
      rows_((rect.height() + tile_side - 1) / tile_side) {}

double TileLoop::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void TileLoop::tell(int samples, std::optional<double> noise) {
  samples_ = samples;
  noise_ = noise;
}

bool TileLoop::run(const MakeWorker& make_worker, double begin, double end) {
  begin_ = begin;
  end_ = end;
  next_tile_ = finished_tiles_ = finished_workers_ = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < threads_; ++i) threads.emplace_back([&] { work(make_worker); });
    watch();
  }
  if (error_) std::rethrow_exception(error_);
  return finished_tiles_ == columns_ * rows_;
}

// What one thread does: takes tiles until none are left or it is told to stop.
void TileLoop::work(const MakeWorker& make_worker) noexcept {
  try {
    const std::unique_ptr<TileWorker> worker = make_worker();
    take_tiles(*worker);
    const std::lock_guard lock(mutex_);
    counts_ += worker->counts();
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::current_exception();
    failed_ = true;
  }
  const std::lock_guard lock(mutex_);
  ++finished_workers_;
  wake_.notify_all();
}

void TileLoop::take_tiles(TileWorker& worker) {
  std::uint64_t reported = 0;
  while (!is_stopped()) {
    const int tile = next_tile_++;
    if (tile >= columns_ * rows_ || !worker.work(tile_rect(tile))) return;
    const std::uint64_t rays = worker.counts().total();
    rays_ += rays - reported;
    reported = rays;
    ++finished_tiles_;
  }
}

// Reports progress until all threads have ended.
void TileLoop::watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, progress_interval, [&] { return finished_workers_ == threads_; })) report(lock);
  report(lock);
}

void TileLoop::report(std::unique_lock<std::mutex>& lock) {
  if (!options_.on_progress) return;
  lock.unlock();
  const double fraction = static_cast<double>(finished_tiles_) / (columns_ * rows_);
  options_.on_progress({begin_ + (end_ - begin_) * fraction, rays_, seconds(), samples_, noise_});
  lock.lock();
}

bool TileLoop::is_stopped() const {
  return failed_.load(std::memory_order_relaxed) || (options_.stop && options_.stop->load(std::memory_order_relaxed));
}

PixelRect TileLoop::tile_rect(int tile) const {
  const int x = rect_.x0 + tile % columns_ * tile_side, y = rect_.y0 + tile / columns_ * tile_side;
  return {x, y, std::min(x + tile_side, rect_.x1), std::min(y + tile_side, rect_.y1)};
}

} // namespace rt
