#include "renderer/render/block_worker.hpp"
#include "renderer/render/noise_blocks.hpp"
#include "renderer/render/pixel_filter.hpp"
#include "renderer/render/sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rt {
namespace {

bool is_finite(const Color& c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

// Samples of each pixel, from the first one to before the last.
struct Pass {
  std::uint32_t begin, end;
};

// What the workers on a picture in this mode share besides.
struct PathPicture {
  FilterSampler filter;
  std::uint64_t seed;
  std::vector<PixelSums> sums; // by the film's pixels
  NoiseBlocks noise;
};

class PathBlocks final : public BlockWorker {
public:
  PathBlocks(PictureJob& job, PathPicture& picture, const Pass& pass)
      : BlockWorker(job), picture_(picture), pass_(pass) {}

private:
  // Where it is stopped, what was traced by then counts.
  bool trace(const PixelRect& block) override {
    StaticVector<PixelPosition, camera_batch_size> pixels; // that need samples
    for_each_pixel(block, [&](int x, int y, std::size_t) {
      if (!picture_.noise.rests(x, y)) pixels.add([&] { return PixelPosition{x, y}; });
      if (pass_.begin == 0) job_.trace_layers(x, y, scratch_);
    });
    if (pixels.size() == 0) return true;
    for (std::uint32_t sample = pass_.begin; sample < pass_.end; ++sample)
      if (!add(pixels, sample)) return false;
    for (const PixelPosition& pixel : pixels) {
      const std::size_t index = job_.index(pixel.x, pixel.y);
      job_.film().color[index] = to_single(picture_.sums[index].mean());
    }
    return true;
  }

  bool add(std::span<const PixelPosition> pixels, std::uint32_t sample) {
    StaticVector<Ray, camera_batch_size> rays;
    StaticVector<SampleStream, camera_batch_size> streams;
    for (const PixelPosition& pixel : pixels) {
      const SampleStream& stream = streams.add([&] { return SampleStream(picture_.seed, pixel.x, pixel.y, sample); });
      rays.add([&] { return sample_ray(job_.camera(), picture_.filter, stream, pixel.x, pixel.y); });
    }
    std::array<Color, camera_batch_size> values;
    job_.trace(*tracer_, rays, streams, values);
    if (job_.is_stopped()) return false;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      picture_.sums[job_.index(pixels[i].x, pixels[i].y)].add(sample, is_finite(values[i]) ? values[i] : black);
    return true;
  }

  PathPicture& picture_;
  Pass pass_;
};

// Passes double the samples, unless time is short: then they take what is left of it.
class Schedule {
public:
  Schedule(const View& view, const RenderOptions& options)
      : all_(static_cast<std::uint32_t>(view.samples)), aim_(view.noise), time_limit_(options.time_limit) {}

  /// Nothing once there is no more to do.
  std::optional<Pass> next(std::uint32_t done, double seconds) const {
    if (done == all_) return std::nullopt;
    if (done == 0) return Pass{0, std::min(time_limit_ ? 2 : first_pass, all_)};
    std::uint32_t count = done;
    if (time_limit_) {
      const double affordable = (*time_limit_ - seconds) / seconds * done;
      if (!(affordable >= 1)) return std::nullopt;
      count = std::min(count, static_cast<std::uint32_t>(std::min(affordable, 65536.0)));
    }
    return Pass{done, std::min(all_, done + count)};
  }

  /// How many samples there will be, by what is known: noise falls with the root of their number.
  double expected(const Pass& pass, double seconds, double noise) const {
    double samples = all_;
    if (aim_ > 0 && std::isfinite(noise)) samples = std::min(samples, pass.begin * std::pow(noise / aim_, 2));
    if (time_limit_ && pass.begin > 0) samples = std::min(samples, pass.begin * *time_limit_ / seconds);
    return std::max(samples, static_cast<double>(pass.end));
  }

private:
  static constexpr std::uint32_t first_pass = 16;
  std::uint32_t all_;
  double aim_;
  std::optional<double> time_limit_;
};

void finish(PictureJob& job, const PathPicture& picture, bool has_layers, RenderStatistics& statistics) {
  double samples = 0;
  Film& film = job.film();
  for (const PixelSums& pixel : picture.sums) {
    samples += pixel.samples();
    if (!has_layers) continue;
    film.error.push_back(to_single(pixel.error()));
    film.samples.push_back(pixel.samples());
  }
  statistics.samples = samples / static_cast<double>(picture.sums.size());
  if (std::isfinite(picture.noise.worst())) statistics.noise = picture.noise.worst();
}

} // namespace

bool render_path(PictureJob& job, const View& view, const RenderOptions& options, TileLoop& loop,
                 RenderStatistics& statistics) {
  PathPicture picture{FilterSampler(view.filter), static_cast<std::uint64_t>(view.seed),
                      std::vector<PixelSums>(job.film().color.size()), NoiseBlocks(job.rect(), view.noise)};
  const Schedule schedule(view, options);
  bool is_complete = true;
  std::optional<Pass> pass = schedule.next(0, 0);
  while (pass && is_complete && !picture.noise.all_rest()) {
    const auto make_worker = [&] { return std::make_unique<PathBlocks>(job, picture, *pass); };
    const double expected = schedule.expected(*pass, loop.seconds(), picture.noise.worst());
    is_complete = loop.run(make_worker, pass->begin / expected, pass->end / expected);
    picture.noise.update(picture.sums);
    const double noise = picture.noise.worst();
    loop.tell(static_cast<int>(pass->end), std::isfinite(noise) ? std::optional(noise) : std::nullopt);
    pass = schedule.next(pass->end, loop.seconds());
  }
  finish(job, picture, options.layers, statistics);
  return is_complete;
}

} // namespace rt
