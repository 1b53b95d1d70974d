#include "renderer/image/image.hpp"

#include <catch2/catch.hpp>

using namespace rt;

TEST_CASE("film: an exr keeps its sums to the last bit") {
  Film film;
  film.width = 2, film.height = 1;
  film.color.resize(2);
  film.sums.resize(2);
  film.sums[0].add(0, {1.0 / 3, 1e15, 0x1p-64});
  film.sums[0].add(1, {-2.5, 0, 1e300});
  film.sums[0].add(2, {1.0 / 7, 0, 0});
  film.noise_states = {5, 0};
  const Image back = decode(encode(film, ImageFormat::exr, {}), "x");
  REQUIRE(back.sums.size() == 2);
  CHECK(back.sums[0] == film.sums[0]);
  CHECK(back.sums[1] == film.sums[1]);
  CHECK(back.noise_states == film.noise_states);
  CHECK(back.sums[0].samples(0) == 2);
  CHECK(back.sums[0].sum(1, 0).value() == -2.5);
  film.sums.clear();
  CHECK(decode(encode(film, ImageFormat::exr, {}), "x").sums.empty());
}
