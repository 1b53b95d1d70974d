#pragma once

#include "renderer/integrators/integrator.hpp"
#include "renderer/math/static_vector.hpp"
#include "renderer/render/camera_rays.hpp"
#include "renderer/render/render.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace rt {

/// Calls f(x, y, i), i counting from 0.
template <class F>
void for_each_pixel(const PixelRect& block, F&& f) {
  std::size_t i = 0;
  for (int y = block.y0; y < block.y1; ++y)
    for (int x = block.x0; x < block.x1; ++x) f(x, y, i++);
}

/// What all workers on a picture share. Each pixel is written by one of them at a time, so the film needs no lock.
class PictureJob {
public:
  /// All must outlive the job. `rect` is the part of the picture that the film holds.
  PictureJob(const CompiledScene& scene, const View& view, IntegratorKind kind, const RenderOptions& options,
             const PixelRect& rect, Film& film);

  const CompiledScene& scene() const { return scene_; }
  const CameraRays& camera() const { return camera_; }
  Film& film() const { return film_; }
  const PixelRect& rect() const { return rect_; }
  /// Of a pixel of the whole picture.
  std::size_t index(int x, int y) const { return film_.index(x - rect_.x0, y - rect_.y0); }
  bool is_stopped() const { return options_.stop && options_.stop->load(std::memory_order_relaxed); }
  std::unique_ptr<Integrator::Worker> make_tracer() const { return integrator_->make_worker(options_.stop); }

  /// The radiance along the camera's rays.
  void trace(Integrator::Worker& tracer, std::span<const Ray> rays, std::span<const SampleStream> streams,
             std::span<Color> values) const;
  /// Fills the film's layers at a pixel, if they are wanted.
  void trace_layers(int x, int y, TraceScratch& scratch) const;
  /// The id of the object that a pixel's centre shows, from 1; 0 for none.
  std::uint32_t object_at(int x, int y) const;
  /// The tile has values that may be displayed.
  void show(const PixelRect& tile);

private:
  const CompiledScene& scene_;
  const RenderOptions& options_;
  PixelRect rect_;
  Film& film_;
  CameraRays camera_;
  std::unique_ptr<const Integrator> integrator_;
  std::vector<Medium> around_eye_;
  std::mutex show_mutex_;
};

Rgb32 to_single(const Color& c);

/// Black, with layers if requested; without pixels if it was stopped. `picture` is the size of the whole.
Film make_film(const PixelRect& rect, const scene::Resolution& picture, const RenderOptions& options);

class TileLoop;

/// Render the picture of a job in either mode; false if stopped.
bool render_whitted(PictureJob& job, const View& view, TileLoop& loop);
bool render_random(PictureJob& job, const View& view, const RenderOptions& options, TileLoop& loop,
                   RenderStatistics& statistics);

} // namespace rt
