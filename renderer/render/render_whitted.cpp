#include "renderer/render/block_worker.hpp"

#include <array>

namespace rt {
namespace {

// All samples of a block at once.
class WhittedBlocks final : public BlockWorker {
public:
  WhittedBlocks(PictureJob& job, const Sampler& sampler) : BlockWorker(job), sampler_(sampler) {}

private:
  // If it is stopped, nothing of the block is in the film.
  bool trace(const PixelRect& block) override {
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

  const Sampler& sampler_;
};

} // namespace

bool render_whitted(PictureJob& job, const View& view, TileLoop& loop) {
  const Sampler sampler(view.samples);
  return loop.run([&] { return std::make_unique<WhittedBlocks>(job, sampler); }, 0, 1);
}

} // namespace rt
