#include "renderer/render/block_worker.hpp"
#include "renderer/render/noise_blocks.hpp"
#include "renderer/render/pixel_filter.hpp"
#include "renderer/render/sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

namespace rt {
namespace {

bool is_finite(const Color& c) {
  return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
}

// A range of samples of each pixel, half-open, counted within the part being rendered.
struct Pass {
  std::uint32_t begin, end;
  bool is_first = false; // of this run
};

// Samples that were dropped. Which is the first does not depend on the order in which they occur.
class DroppedSamples {
public:
  void add(const PixelPosition& pixel) {
    const std::lock_guard lock(mutex_);
    if (count_++ == 0 || std::pair(pixel.y, pixel.x) < std::pair(first_.y, first_.x)) first_ = pixel;
  }
  std::uint64_t count() const { return count_; }
  const PixelPosition& first() const { return first_; }

private:
  std::mutex mutex_;
  std::uint64_t count_ = 0;
  PixelPosition first_{};
};

// What the workers on a picture share in addition.
struct SampledPicture {
  FilterSampler filter;
  std::uint64_t seed;
  SamplePart part;
  std::vector<PixelSums> sums; // by the film's pixels
  NoiseBlocks noise;
  DroppedSamples dropped{};

  // The part's n-th sample, as a sample of the whole picture.
  std::uint32_t sample(std::uint32_t n) const {
    const auto count = static_cast<std::uint32_t>(part.count), index = static_cast<std::uint32_t>(part.index - 1);
    return 2 * (n / 2 * count + index) + n % 2;
  }
};

// How many of the first `all` samples of a picture belong to the part.
std::uint32_t samples_in(const SamplePart& part, std::uint32_t all) {
  const auto count = static_cast<std::uint32_t>(part.count), index = static_cast<std::uint32_t>(part.index - 1);
  const std::uint32_t pairs = all / 2, rest = all % 2 == 1 && pairs % count == index ? 1 : 0;
  return 2 * (pairs / count + (index < pairs % count ? 1 : 0)) + rest;
}

class SampledBlocks final : public BlockWorker {
public:
  SampledBlocks(PictureJob& job, SampledPicture& picture, const Pass& pass)
      : BlockWorker(job), picture_(picture), pass_(pass) {}

private:
  // If it is stopped, what was traced by then counts.
  bool trace(const PixelRect& block) override {
    StaticVector<PixelPosition, camera_batch_size> pixels; // that need samples
    for_each_pixel(block, [&](int x, int y, std::size_t) {
      if (!picture_.noise.rests(x, y) && picture_.sums[job_.index(x, y)].samples() < pass_.end)
        pixels.add([&] { return PixelPosition{x, y}; });
      if (pass_.is_first) job_.trace_layers(x, y, scratch_);
    });
    if (pixels.size() == 0) return true;
    bool is_whole = true;
    for (std::uint32_t n = pass_.begin; n < pass_.end && is_whole; ++n) is_whole = add(pixels, n);
    for (const PixelPosition& pixel : pixels) {
      const std::size_t index = job_.index(pixel.x, pixel.y);
      job_.film().color[index] = to_single(picture_.sums[index].mean());
    }
    return is_whole;
  }

  // The part's n-th sample of those pixels that do not have it yet.
  bool add(std::span<const PixelPosition> all, std::uint32_t n) {
    StaticVector<PixelPosition, camera_batch_size> pixels;
    for (const PixelPosition& pixel : all)
      if (picture_.sums[job_.index(pixel.x, pixel.y)].samples() == n) pixels.add([&] { return pixel; });
    if (pixels.size() == 0) return true;
    const std::uint32_t sample = picture_.sample(n);
    StaticVector<Ray, camera_batch_size> rays;
    StaticVector<SampleStream, camera_batch_size> streams;
    for (const PixelPosition& pixel : pixels) {
      const SampleStream& stream = streams.add([&] { return SampleStream(picture_.seed, pixel.x, pixel.y, sample); });
      rays.add([&] { return sample_ray(job_.camera(), picture_.filter, stream, pixel.x, pixel.y); });
    }
    std::array<Color, camera_batch_size> values;
    job_.trace(*tracer_, rays, streams, values);
    if (job_.is_stopped()) return false;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const bool counts = is_finite(values[i]);
      if (!counts) picture_.dropped.add(pixels[i]);
      picture_.sums[job_.index(pixels[i].x, pixels[i].y)].add(sample, counts ? values[i] : black);
    }
    return true;
  }

  SampledPicture& picture_;
  Pass pass_;
};

// Passes double the samples, unless time is short: then they take what is left of it.
class Schedule {
public:
  Schedule(const View& view, const RenderOptions& options)
      : all_(samples_in(options.part, static_cast<std::uint32_t>(view.samples))), aim_(view.noise),
        time_limit_(options.time_limit) {}

  /// Nothing once there is no more to do.
  std::optional<Pass> next(std::uint32_t done, double seconds) const {
    if (done >= all_) return std::nullopt;
    if (done == 0) return Pass{0, std::min(time_limit_ ? 2 : first_pass, all_)};
    std::uint32_t count = done;
    if (time_limit_) {
      const double affordable = (*time_limit_ - seconds) / seconds * done;
      if (!(affordable >= 1)) return std::nullopt;
      count = std::min(count, static_cast<std::uint32_t>(std::min(affordable, 65536.0)));
    }
    return Pass{done, std::min(all_, done + count)};
  }

  /// The predicted number of samples: noise falls with the root of their number.
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

void finish(PictureJob& job, SampledPicture& picture, const RenderOptions& options, RenderStatistics& statistics) {
  double samples = 0;
  Film& film = job.film();
  for (const PixelSums& pixel : picture.sums) samples += pixel.samples();
  statistics.samples = samples / static_cast<double>(picture.sums.size());
  if (std::isfinite(picture.noise.worst())) statistics.noise = picture.noise.worst();
  if (picture.dropped.count() > 0) {
    const PixelPosition& first = picture.dropped.first();
    statistics.dropped = {picture.dropped.count(), first.x, first.y, job.object_at(first.x, first.y)};
  }
  film.sums = std::move(picture.sums);
  show_sums(film, options.layers);
  if (options.sums)
    for_each_pixel(job.rect(),
                   [&](int x, int y, std::size_t) { film.noise_states.push_back(picture.noise.state(x, y)); });
  else
    film.sums = {};
}

// The least number of samples of any pixel that needs more.
std::uint32_t least_samples(const PictureJob& job, const SampledPicture& picture) {
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  for_each_pixel(job.rect(), [&](int x, int y, std::size_t i) {
    if (!picture.noise.rests(x, y)) least = std::min(least, picture.sums[i].samples());
  });
  return least;
}

} // namespace

void show_sums(Film& film, bool has_error) {
  film.error.clear();
  film.samples.clear();
  for (std::size_t i = 0; i < film.sums.size(); ++i) {
    film.color[i] = to_single(film.sums[i].mean());
    if (!has_error) continue;
    film.error.push_back(to_single(film.sums[i].error()));
    film.samples.push_back(film.sums[i].samples());
  }
}

bool render_random(PictureJob& job, const View& view, const RenderOptions& options, TileLoop& loop,
                   RenderStatistics& statistics) {
  SampledPicture picture{FilterSampler(view.filter), static_cast<std::uint64_t>(view.seed), options.part,
                         std::vector<PixelSums>(job.film().color.size()), NoiseBlocks(job.rect(), view.noise)};
  const Schedule schedule(view, options);
  bool is_complete = true;
  std::optional<Pass> pass = schedule.next(0, 0);
  if (options.earlier) {
    picture.sums = options.earlier->sums;
    picture.noise.restore(options.earlier->noise_states, picture.sums);
    const std::uint32_t done = least_samples(job, picture);
    while (pass && pass->end <= done) pass = schedule.next(pass->end, 0);
  }
  if (!pass || options.earlier) {
    const auto make_worker = [&] { return std::make_unique<SampledBlocks>(job, picture, Pass{0, 0, true}); };
    is_complete = loop.run(make_worker, 0, 0); // for the layers
  } else {
    pass->is_first = true;
  }
  while (pass && is_complete && !picture.noise.all_rest()) {
    const auto make_worker = [&] { return std::make_unique<SampledBlocks>(job, picture, *pass); };
    const double expected = schedule.expected(*pass, loop.seconds(), picture.noise.worst());
    is_complete = loop.run(make_worker, pass->begin / expected, pass->end / expected);
    if (!is_complete) break;
    picture.noise.update(picture.sums);
    const double noise = picture.noise.worst();
    loop.tell(static_cast<int>(pass->end), std::isfinite(noise) ? std::optional(noise) : std::nullopt);
    pass = schedule.next(pass->end, loop.seconds());
  }
  finish(job, picture, options, statistics);
  return is_complete;
}

} // namespace rt
