#include "renderer/math/color.hpp"
#include "renderer/render/noise_blocks.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

namespace {

// A picture in which every pixel is `light`, and its halves are 2·`error` apart.
std::vector<PixelSums> picture(const PixelRect& rect, double light, double error) {
  std::vector<PixelSums> sums(static_cast<std::size_t>(rect.width() * rect.height()));
  for (PixelSums& pixel : sums) {
    pixel.add(0, grey(light - error));
    pixel.add(1, grey(light + error));
  }
  return sums;
}

} // namespace

// The slope by differences of the encoding itself.
TEST_CASE("noise blocks: noise is what sampling moves in the finished picture") {
  const PixelRect rect{0, 0, 32, 16};
  for (const double light : {0.001, 0.01, 0.2, 0.5, 0.99}) {
    NoiseBlocks noise(rect, 0);
    CHECK(std::isinf(noise.worst()));
    noise.update(picture(rect, light, 1e-5));
    const double slope = (linear_to_srgb(light + 1e-6) - linear_to_srgb(light - 1e-6)) / 2e-6;
    CHECK(noise.worst() == Approx(slope * 1e-5).epsilon(1e-4));
  }
  NoiseBlocks noise(rect, 0);
  noise.update(picture(rect, 4, 0.1));
  CHECK(noise.worst() == Approx(0.43958 / 4 * 0.1).epsilon(1e-4));
}

TEST_CASE("noise blocks: one rests once it and its neighbours were calm twice in a row") {
  const PixelRect rect{0, 0, 64, 16}; // four blocks side by side
  auto sums = picture(rect, 0.5, 1e-4);
  for (int y = 0; y < 16; ++y) { // the last one is noisy
    for (int x = 48; x < 64; ++x) {
      PixelSums& pixel = sums[static_cast<std::size_t>(y * 64 + x)];
      pixel.add(2, grey(0.2));
      pixel.add(3, grey(0.8));
    }
  }
  NoiseBlocks noise(rect, 0.01);
  noise.update(sums);
  CHECK_FALSE(noise.rests(0, 0));
  noise.update(sums);
  CHECK(noise.rests(0, 0));
  CHECK(noise.rests(31, 15));
  CHECK_FALSE(noise.rests(32, 0));
  CHECK_FALSE(noise.rests(63, 0));
  CHECK_FALSE(noise.all_rest());
  CHECK(noise.worst() > 0.05);
}

TEST_CASE("noise blocks: they are those of the whole picture, wherever a part begins") {
  const PixelRect rect{8, 8, 24, 24};
  auto sums = picture(rect, 0.5, 1e-4);
  sums[0].add(2, grey(0));
  sums[0].add(3, grey(20)); // in the block of (8, 8) alone
  NoiseBlocks noise(rect, 1e-3);
  noise.update(sums);
  // Of 8 × 8 pixels one is far off.
  CHECK(noise.worst() > 0.1);
  noise.update(sums);
  CHECK_FALSE(noise.rests(23, 23)); // all four are neighbours
}
