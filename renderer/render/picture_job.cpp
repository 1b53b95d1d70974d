#include "renderer/render/picture_job.hpp"

#include "renderer/compile/touching.hpp"
#include "renderer/shading/materials.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

namespace rt {
namespace {

using Clock = std::chrono::steady_clock;

// Clearing gigabytes takes seconds: a part at a time, so that it can be interrupted.
template <class Pixel>
bool resize_in_parts(std::vector<Pixel>& pixels, std::size_t size, const Pixel& value, const RenderOptions& options,
                     Clock::time_point start) {
  constexpr std::size_t part = 1 << 22;
  pixels.reserve(size);
  while (pixels.size() < size) {
    if (options.stop && options.stop->load(std::memory_order_relaxed)) return false;
    pixels.resize(std::min(size, pixels.size() + part), value);
    if (options.on_progress && pixels.size() < size)
      options.on_progress({0, 0, std::chrono::duration<double>(Clock::now() - start).count()});
  }
  return true;
}

Xyz32 to_single(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

} // namespace

Rgb32 to_single(const Color& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

Film make_film(const PixelRect& rect, const scene::Resolution& picture, const RenderOptions& options) {
  Film film;
  film.width = rect.width();
  film.height = rect.height();
  film.left = rect.x0;
  film.top = rect.y0;
  film.picture_width = picture[0];
  film.picture_height = picture[1];
  const std::size_t pixels = static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  const Clock::time_point start = Clock::now();
  const auto fill = [&](auto& layer, const auto& value) {
    return resize_in_parts(layer, pixels, value, options, start);
  };
  bool is_whole = fill(film.color, Rgb32{});
  if (options.layers) {
    is_whole = is_whole && fill(film.depth, std::numeric_limits<double>::infinity()) && fill(film.normal, Xyz32{}) &&
               fill(film.position, Xyz32{}) && fill(film.object_id, std::uint32_t{0}) && fill(film.albedo, Rgb32{});
  }
  if (!is_whole) return {};
  return film;
}

PictureJob::PictureJob(const CompiledScene& scene, const View& view, IntegratorKind kind, const RenderOptions& options,
                       const PixelRect& rect, Film& film)
    : scene_(scene), options_(options), rect_(rect), film_(film), camera_(view.camera, view.size),
      integrator_(make_integrator(kind, scene)), around_eye_(scene.around(view.camera.at)) {}

void PictureJob::trace(Integrator::Worker& tracer, std::span<const Ray> rays, std::span<const SampleStream> streams,
                       std::span<Color> values) const {
  const bool has_one_eye = camera_.has_one_eye() && (streams.empty() || !camera_.has_lens());
  if (has_one_eye || !scene_.uses_ior()) return tracer.radiance(rays, streams, around_eye_, values);
  for (std::size_t i = 0; i < rays.size(); ++i)
    tracer.radiance(rays.subspan(i, 1), streams.empty() ? streams : streams.subspan(i, 1),
                    scene_.around(rays[i].origin), values.subspan(i, 1));
}

void PictureJob::trace_layers(int x, int y, TraceScratch& scratch) const {
  if (!options_.layers) return;
  const Ray ray = camera_.ray(x + 0.5, y + 0.5);
  const std::optional<MetSurface> first = first_surface(scene_, ray, {}, scratch);
  if (!first) return;
  const std::size_t i = index(x, y);
  const Surface& surface = first->surface;
  MaterialValues values;
  const Vec3 n = surface.shading_normal;
  film_.depth[i] = first->hit.t;
  film_.normal[i] = to_single(dot(n, ray.direction) > 0 ? -n : n);
  film_.position[i] = to_single(surface.position);
  film_.object_id[i] = static_cast<std::uint32_t>(surface.order + 1);
  film_.albedo[i] = rt::to_single(scene_.values(surface, values).color);
}

std::uint32_t PictureJob::object_at(int x, int y) const {
  TraceScratch scratch;
  const std::optional<MetSurface> first = first_surface(scene_, camera_.ray(x + 0.5, y + 0.5), {}, scratch);
  return first ? static_cast<std::uint32_t>(first->surface.order + 1) : 0;
}

void PictureJob::show(const PixelRect& tile) {
  if (!options_.on_tile) return;
  const std::lock_guard lock(show_mutex_);
  options_.on_tile(film_, {tile.x0 - rect_.x0, tile.y0 - rect_.y0, tile.x1 - rect_.x0, tile.y1 - rect_.y0});
}

} // namespace rt
