#include "renderer/render/block_worker.hpp"

#include <algorithm>

namespace rt {
namespace {

constexpr int block_side = 4;
static_assert(block_side * block_side <= camera_batch_size);

} // namespace

bool BlockWorker::work(const PixelRect& tile) {
  for (int y = tile.y0; y < tile.y1; y += block_side)
    for (int x = tile.x0; x < tile.x1; x += block_side)
      if (!trace({x, y, std::min(x + block_side, tile.x1), std::min(y + block_side, tile.y1)})) return false;
  job_.show(tile);
  return true;
}

} // namespace rt
