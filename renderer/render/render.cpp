#include "renderer/render/render.hpp"

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/integrator.hpp"
#include "renderer/math/static_vector.hpp"
#include "renderer/render/camera_rays.hpp"
#include "renderer/scene/validation/validate.hpp"
#include "renderer/shading/materials.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <thread>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr int tile_side = 16;
constexpr int block_side = 4;
static_assert(block_side * block_side <= camera_batch_size);
constexpr std::chrono::milliseconds progress_interval{100};

bool is_stopped(const RenderOptions& options) {
  return options.stop && options.stop->load(std::memory_order_relaxed);
}

// Gigabytes take seconds to be cleared: a part at a time, so that they can be waited for, and given up.
template <class Pixel>
bool resize_in_parts(std::vector<Pixel>& pixels, std::size_t size, const Pixel& value, const RenderOptions& options,
                     Clock::time_point start) {
  constexpr std::size_t part = 1 << 22;
  pixels.reserve(size);
  while (pixels.size() < size) {
    if (is_stopped(options)) return false;
    pixels.resize(std::min(size, pixels.size() + part), value);
    if (options.on_progress && pixels.size() < size) options.on_progress({0, 0, seconds_since(start)});
  }
  return true;
}

// A film without pixels where it was stopped.
Film make_film(const PixelRect& rect, const scene::Resolution& picture, const RenderOptions& options,
               Clock::time_point start) {
  Film film;
  film.width = rect.width();
  film.height = rect.height();
  film.left = rect.x0;
  film.top = rect.y0;
  film.picture_width = picture[0];
  film.picture_height = picture[1];
  const std::size_t pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  const auto fill = [&](auto& layer, const auto& value) {
    return resize_in_parts(layer, pixels, value, options, start);
  };
  bool is_whole = fill(film.color, Rgb32{});
  if (options.layers) {
    is_whole = is_whole && fill(film.depth, std::numeric_limits<double>::infinity()) && fill(film.normal, Xyz32{}) &&
               fill(film.position, Xyz32{}) && fill(film.object_id, std::uint32_t{0}) && fill(film.albedo, Rgb32{});
  }
  return is_whole ? film : Film{};
}

Rgb32 to_single(const Color& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}
Xyz32 to_single(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Everything the workers share. Each pixel is written by one of them, so the film needs no lock.
class Job {
public:
  Job(const View& view, const CompiledScene& scene, const RenderOptions& options, const PixelRect& rect, Film& film)
      : scene_(scene), options_(options), rect_(rect), film_(film), camera_(view.camera, view.size),
        integrator_(make_integrator(IntegratorKind::whitted, scene)), around_eye_(scene.around(view.camera.at)),
        sampler_(view.samples), columns_((rect.width() + tile_side - 1) / tile_side),
        rows_((rect.height() + tile_side - 1) / tile_side) {}

  /// What one thread does: takes tiles until none are left or it is told to stop.
  void work() noexcept {
    try {
      Worker worker(*this);
      worker.run();
      const std::lock_guard lock(mutex_);
      counts_ += worker.counts();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
      failed_ = true;
    }
    const std::lock_guard lock(mutex_);
    ++finished_workers_;
    wake_.notify_all();
  }

  /// Reports progress until `workers` threads have ended.
  void watch(int workers, Clock::time_point start) {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, progress_interval, [&] { return finished_workers_ == workers; })) report(lock, start);
    if (options_.on_progress) report(lock, start);
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }
  bool is_complete() const { return finished_tiles_ == columns_ * rows_; }
  const RayCounts& counts() const { return counts_; }

private:
  class Worker {
  public:
    explicit Worker(Job& job) : job_(job), tracer_(job.integrator_->make_worker(job.options_.stop)) {}

    void run() {
      while (!job_.is_stopped()) {
        const int tile = job_.next_tile_++;
        if (tile >= job_.columns_ * job_.rows_) return;
        const PixelRect rect = job_.tile_rect(tile);
        if (!trace_tile(rect)) return;
        const std::uint64_t rays = counts().total();
        job_.rays_ += rays - reported_;
        reported_ = rays;
        job_.finish(rect);
      }
    }

    const RayCounts& counts() const { return tracer_->counts(); }

  private:
    // Block by block, so that the rays of a packet run close together.
    bool trace_tile(const PixelRect& tile) {
      for (int y = tile.y0; y < tile.y1; y += block_side) {
        for (int x = tile.x0; x < tile.x1; x += block_side) {
          if (!trace_block({x, y, std::min(x + block_side, tile.x1), std::min(y + block_side, tile.y1)})) return false;
        }
      }
      return true;
    }

    // False, and nothing in the film, where it was stopped: a single ray among many panes of glass may take seconds.
    bool trace_block(const PixelRect& block) {
      const Sampler& sampler = job_.sampler_;
      std::array<Color, camera_batch_size> sums{}, values;
      for (int sample = 0; sample < sampler.samples(); ++sample) {
        StaticVector<Ray, camera_batch_size> rays;
        for_each_pixel(block, [&](int x, int y, std::size_t) {
          rays.add([&] { return job_.camera_.ray({x, y}, sampler, sample); });
        });
        trace_rays(rays, values);
        if (job_.is_stopped()) return false;
        for (std::size_t i = 0; i < rays.size(); ++i) sums[i] += values[i];
      }
      for_each_pixel(block, [&](int x, int y, std::size_t i) {
        const std::size_t index = job_.film_.index(x - job_.rect_.x0, y - job_.rect_.y0);
        job_.film_.color[index] = to_single(sums[i] * (1.0 / sampler.samples()));
        if (job_.options_.layers) trace_layers(job_.camera_.ray(x + 0.5, y + 0.5), index);
      });
      return true;
    }

    template <class F>
    static void for_each_pixel(const PixelRect& block, F&& f) {
      std::size_t i = 0;
      for (int y = block.y0; y < block.y1; ++y)
        for (int x = block.x0; x < block.x1; ++x) f(x, y, i++);
    }

    void trace_rays(std::span<const Ray> rays, std::span<Color> values) {
      if (job_.camera_.has_one_eye() || !job_.scene_.uses_ior())
        return tracer_->radiance(rays, job_.around_eye_, values);
      for (std::size_t i = 0; i < rays.size(); ++i)
        tracer_->radiance(rays.subspan(i, 1), job_.scene_.around(rays[i].origin), values.subspan(i, 1));
    }

    void trace_layers(const Ray& ray, std::size_t index) {
      const RayHit hit = job_.scene_.nearest(ray, {}, scratch_);
      if (!hit) return;
      const Surface surface = job_.scene_.surface(ray, hit);
      MaterialValues values;
      const Vec3 n = surface.shading_normal;
      job_.film_.depth[index] = hit.t;
      job_.film_.normal[index] = to_single(dot(n, ray.direction) > 0 ? -n : n);
      job_.film_.position[index] = to_single(surface.point);
      job_.film_.object_id[index] = static_cast<std::uint32_t>(surface.order + 1);
      job_.film_.albedo[index] = to_single(job_.scene_.values(surface, values).color);
    }

    Job& job_;
    std::unique_ptr<Integrator::Worker> tracer_;
    TraceScratch scratch_;
    std::uint64_t reported_ = 0;
  };

  bool is_stopped() const {
    return failed_.load(std::memory_order_relaxed) || (options_.stop && options_.stop->load(std::memory_order_relaxed));
  }

  PixelRect tile_rect(int tile) const {
    const int x = rect_.x0 + tile % columns_ * tile_side, y = rect_.y0 + tile / columns_ * tile_side;
    return {x, y, std::min(x + tile_side, rect_.x1), std::min(y + tile_side, rect_.y1)};
  }

  void finish(const PixelRect& tile) {
    ++finished_tiles_;
    if (!options_.on_tile) return;
    const std::lock_guard lock(tile_mutex_);
    options_.on_tile(film_, {tile.x0 - rect_.x0, tile.y0 - rect_.y0, tile.x1 - rect_.x0, tile.y1 - rect_.y0});
  }

  void report(std::unique_lock<std::mutex>& lock, Clock::time_point start) {
    if (!options_.on_progress) return;
    lock.unlock();
    const double fraction = static_cast<double>(finished_tiles_) / (columns_ * rows_);
    options_.on_progress({fraction, rays_, seconds_since(start)});
    lock.lock();
  }

  const CompiledScene& scene_;
  const RenderOptions& options_;
  PixelRect rect_;
  Film& film_;
  CameraRays camera_;
  std::unique_ptr<const Integrator> integrator_;
  std::vector<Medium> around_eye_;
  Sampler sampler_;
  int columns_, rows_;
  std::atomic<int> next_tile_ = 0, finished_tiles_ = 0;
  std::atomic<std::uint64_t> rays_ = 0;
  std::atomic<bool> failed_ = false;

  std::mutex tile_mutex_; // held while a tile is shown
  std::mutex mutex_;      // guards what follows
  std::condition_variable wake_;
  int finished_workers_ = 0;
  RayCounts counts_;
  std::exception_ptr error_;
};

int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace

namespace {

void require_valid(const View& view) {
  scene::Scene seen; // nothing but the view
  seen.camera = view.camera;
  seen.size = view.size;
  seen.samples = view.samples;
  require_none(validate_settings(seen));
}

} // namespace

View view_of(const scene::Scene& scene) {
  return {scene.camera, scene.size, scene.samples, tone_mapping(scene)};
}

Rendered render(const scene::Scene& scene, const RenderOptions& options) {
  const Clock::time_point build_start = Clock::now();
  const CompiledScene compiled(scene, thread_count(options.threads));
  const double build_seconds = seconds_since(build_start);
  Rendered result = render(compiled, view_of(scene), options);
  result.statistics.primitives = count_primitives(scene);
  result.statistics.build_seconds = build_seconds;
  return result;
}

Rendered render(const CompiledScene& scene, const View& view, const RenderOptions& options) {
  require_valid(view);
  Rendered result;
  RenderStatistics& statistics = result.statistics;
  statistics.threads = thread_count(options.threads);
  const Clock::time_point trace_start = Clock::now();
  const PixelRect rect = options.crop.value_or(PixelRect{0, 0, view.size[0], view.size[1]});
  result.film = make_film(rect, view.size, options, trace_start);
  if (result.film.color.empty()) {
    result.is_complete = false;
    return result;
  }
  result.film.tone_mapping = view.tone_mapping;
  Job job(view, scene, options, rect, result.film);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < statistics.threads; ++i) threads.emplace_back([&job] { job.work(); });
    job.watch(statistics.threads, trace_start);
  }
  job.rethrow();
  statistics.trace_seconds = seconds_since(trace_start);
  statistics.rays = job.counts();
  result.is_complete = job.is_complete();
  return result;
}

} // namespace rt
