#include "renderer/render/render.hpp"

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/render/picture_job.hpp"
#include "renderer/render/sums.hpp"
#include "renderer/render/tile_loop.hpp"
#include "renderer/scene/validation/validate.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <thread>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

int thread_count(int wanted) {
  if (wanted > 0) return wanted;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

IntegratorKind kind_of(scene::Mode mode) {
  switch (mode) {
  case scene::Mode::whitted:
    return IntegratorKind::whitted;
  case scene::Mode::path:
    return IntegratorKind::path;
  case scene::Mode::occlusion:
    return IntegratorKind::occlusion;
  }
  assert(false);
  return IntegratorKind::whitted;
}

void require_valid(const View& view) {
  scene::Scene seen; // only the view
  seen.camera = view.camera;
  seen.size = view.size;
  seen.mode = view.mode;
  seen.samples = view.samples;
  require_none(validate_settings(seen));
}

} // namespace

View view_of(const scene::Scene& scene) {
  return {scene.camera,
          scene.size,
          scene::sample_count(scene),
          tone_mapping(scene),
          scene.mode.value_or(scene::Mode::whitted),
          scene.seed.value_or(0),
          scene.filter.value_or(scene::PixelFilter::blackman_harris),
          scene.noise.value_or(0)};
}

View whitted_view_of(const scene::Scene& scene) {
  return {scene.camera, scene.size, scene::whitted_samples(scene), tone_mapping(scene)};
}

std::uint64_t sums_bytes(const PixelRect& rect) {
  return static_cast<std::uint64_t>(rect.width()) * static_cast<std::uint64_t>(rect.height()) * sizeof(PixelSums);
}

Rendered render(const scene::Scene& scene, const RenderOptions& options) {
  const Clock::time_point build_start = Clock::now();
  const CompiledScene compiled(scene, thread_count(options.threads));
  const double build_seconds = std::chrono::duration<double>(Clock::now() - build_start).count();
  Rendered result = render(compiled, view_of(scene), options);
  result.statistics.primitives = count_primitives(scene);
  result.statistics.build_seconds = build_seconds;
  return result;
}

Rendered render(const CompiledScene& scene, const View& view, const RenderOptions& options) {
  require_valid(view);
  const bool is_random = view.mode != scene::Mode::whitted;
  Rendered result;
  const PixelRect rect = options.crop.value_or(PixelRect{0, 0, view.size[0], view.size[1]});
  TileLoop loop(rect, thread_count(options.threads), options);
  result.film = make_film(rect, view.size, options);
  if (result.film.color.empty()) {
    result.is_complete = false;
    return result;
  }
  result.film.tone_mapping = view.tone_mapping;
  PictureJob job(scene, view, is_random ? kind_of(view.mode) : options.integrator, options, rect, result.film);
  result.statistics.samples = view.samples;
  result.is_complete =
      is_random ? render_random(job, view, options, loop, result.statistics) : render_whitted(job, view, loop);
  result.statistics.threads = loop.threads();
  result.statistics.trace_seconds = loop.seconds();
  result.statistics.rays = loop.counts();
  return result;
}

} // namespace rt
