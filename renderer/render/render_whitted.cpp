#include "renderer/render/picture_job.hpp"
#include "renderer/render/tile_loop.hpp"

#include <array>

namespace rt {
namespace {

// All samples of a tile at once.
class WhittedTiles final : public TileWorker {
public:
  WhittedTiles(PictureJob& job, const Sampler& sampler) : job_(job), sampler_(sampler), tracer_(job.make_tracer()) {}

  bool work(const PixelRect& tile) override {
    if (!for_each_block(tile, [&](const PixelRect& block) { return trace(block); })) return false;
    job_.show(tile);
    return true;
  }
  const RayCounts& counts() const override { return tracer_->counts(); }

private:
  // False, and nothing in the film, where it was stopped: a single ray among many panes of glass may take seconds.
  bool trace(const PixelRect& block) {
    std::array<Color, camera_batch_size> sums{}, values;
    for (int sample = 0; sample < sampler_.samples(); ++sample) {
      StaticVector<Ray, camera_batch_size> rays;
      for_each_pixel(block, [&](int x, int y, std::size_t) {
        rays.add([&] { return job_.camera().ray({x, y}, sampler_, sample); });
      });
      job_.trace(*tracer_, rays, {}, values);
      if (job_.is_stopped()) return false;
      for (std::size_t i = 0; i < rays.size(); ++i) sums[i] += values[i];
    }
    for_each_pixel(block, [&](int x, int y, std::size_t i) {
      job_.film().color[job_.index(x, y)] = to_single(sums[i] * (1.0 / sampler_.samples()));
      job_.trace_layers(x, y, scratch_);
    });
    return true;
  }

  PictureJob& job_;
  const Sampler& sampler_;
  std::unique_ptr<Integrator::Worker> tracer_;
  TraceScratch scratch_;
};

} // namespace

bool render_whitted(PictureJob& job, const View& view, TileLoop& loop) {
  const Sampler sampler(view.samples);
  return loop.run([&] { return std::make_unique<WhittedTiles>(job, sampler); }, 0, 1);
}

} // namespace rt
