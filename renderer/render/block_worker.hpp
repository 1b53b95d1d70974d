#pragma once

#include "renderer/render/picture_job.hpp"
#include "renderer/render/tile_loop.hpp"

#include <memory>

namespace rt {

/// Traces a tile block by block; the rays of a block are traced together.
class BlockWorker : public TileWorker {
public:
  explicit BlockWorker(PictureJob& job) : job_(job), tracer_(job.make_tracer()) {}
  bool work(const PixelRect& tile) final;
  const RayCounts& counts() const final { return tracer_->counts(); }

protected:
  /// At most `camera_batch_size` pixels. False if it was stopped: a single ray among many panes of glass may take
  /// seconds.
  virtual bool trace(const PixelRect& block) = 0;

  PictureJob& job_;
  std::unique_ptr<Integrator::Worker> tracer_;
  TraceScratch scratch_;
};

} // namespace rt
