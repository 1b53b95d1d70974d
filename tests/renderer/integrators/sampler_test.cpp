#include "renderer/integrators/sampler.hpp"

#include <catch2/catch.hpp>

using namespace rt;

namespace {

void check_place(const Sampler& sampler, int sample, double x, double y) {
  for (const PixelPosition pixel : {PixelPosition{0, 0}, PixelPosition{17, 4}}) {
    CHECK(sampler.get(pixel, sample, 0) == Approx(x).epsilon(1e-15));
    CHECK(sampler.get(pixel, sample, 1) == Approx(y).epsilon(1e-15));
  }
}

} // namespace

TEST_CASE("sampler: a single sample is in the middle of its pixel") {
  check_place(Sampler(1), 0, 0.5, 0.5);
}

TEST_CASE("sampler: samples are the cells' middles of a regular grid, row by row") {
  const Sampler four(4);
  CHECK(four.samples() == 4);
  check_place(four, 0, 0.25, 0.25);
  check_place(four, 1, 0.75, 0.25);
  check_place(four, 2, 0.25, 0.75);
  check_place(four, 3, 0.75, 0.75);
  const Sampler nine(9);
  CHECK(nine.samples() == 9);
  check_place(nine, 5, 5.0 / 6, 0.5);
  check_place(nine, 6, 1.0 / 6, 5.0 / 6);
}
