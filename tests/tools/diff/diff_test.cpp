#include "tests/support/program.hpp"
#include "tools/diff/diff.hpp"
#include "tools/povray/compare/heat.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace rt;
using namespace rt::tools;

namespace {

constexpr int width = 40, height = 30;

template <class Value>
std::vector<double> grey(Value&& value) {
  std::vector<double> picture;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture.push_back(value(x, y));
  return picture;
}

int waves(int x, int y) {
  return (x * x + 3 * y * y + x * y) % 256;
}
int torn(int x, int y) {
  return (x + y) % 3 ? (waves(x, y) * 7 + x * 11) / 8 % 256 : waves(x, y);
}
int noisy(int x, int y) {
  return std::clamp(waves(x, y) + (x * 5 + y * 3) % 17 - 8, 0, 255);
}

// Grey as it is shown, so that sRGB values are what is asked for.
Film shown(double value, int side = 12) {
  const auto linear = static_cast<float>(srgb_to_linear(value));
  return film_of(std::vector<Rgb32>(static_cast<std::size_t>(side * side), Rgb32{linear, linear, linear}), side, side);
}

} // namespace

// The numbers are those of scikit-image 0.19.3, structural_similarity(a, b, gaussian_weights=True, sigma=1.5,
// use_sample_covariance=False, data_range=255). On its camera picture of 512 × 512 and the noise of its own test (seed
// 5, deviation 20), for which IPOL's imdiff gives 0.357959, it gives 0.3579642 and `rtlang diff` 0.357964.
TEST_CASE("diff: structural similarity is that of scikit-image") {
  const auto a = grey(waves), b = grey(torn), c = grey(noisy);
  CHECK(structural_similarity(a, b, width, height, 255) == Approx(0.9371309805415842).epsilon(1e-12));
  CHECK(structural_similarity(a, c, width, height, 255) == Approx(0.99783956427469).epsilon(1e-12));
  CHECK(structural_similarity(b, c, width, height, 255) == Approx(0.9350813281851076).epsilon(1e-12));
  CHECK(structural_similarity(a, a, width, height, 255) == Approx(1).epsilon(1e-14));
}

// (2 m n + C₁) / (m² + n² + C₁), because nothing varies.
TEST_CASE("diff: structural similarity of two even greys follows from their means") {
  const auto a = grey([](int, int) { return 0.3; }), b = grey([](int, int) { return 0.5; });
  CHECK(structural_similarity(a, b, width, height) == Approx((2 * 0.15 + 1e-4) / (0.09 + 0.25 + 1e-4)).epsilon(1e-9));
}

TEST_CASE("diff: the mean error and its decibels are of the values as shown") {
  const Difference d = difference(shown(0.6), shown(0.5));
  CHECK(d.rmse == Approx(0.1).epsilon(1e-6));
  CHECK(d.psnr == Approx(20).epsilon(1e-6));
  CHECK(d.color_max == Approx(srgb_to_linear(0.6) - srgb_to_linear(0.5)).epsilon(1e-6));
  CHECK(d.color_equal == 0);
  const Difference none = difference(shown(0.6), shown(0.6));
  CHECK(none.rmse == 0);
  CHECK(std::isinf(none.psnr));
  CHECK(none.color_equal == 144);
}

TEST_CASE("diff: one pixel that is no number, or infinite, is a difference") {
  Film a = shown(0.5), b = shown(0.5);
  a.color[17].g = std::numeric_limits<float>::quiet_NaN();
  CHECK(std::isinf(difference(a, b).color_max));
  CHECK(difference(a, b).color_max_x == 5);
  CHECK(difference(a, b).color_max_y == 1);
  b.color[17].g = a.color[17].g;
  CHECK(difference(a, b).color_max == 0);
}

TEST_CASE("diff: pictures of any kind of file, a map on demand, and the exit code says whether the gates hold") {
  const tests::TestFolder folder;
  tests::RunOptions here;
  here.folder = folder.path();
  const std::string scene =
      "size: [40, 30]\ncamera { at: [0, 1, 5] }\nlight { at: [2, 4, 3] }\nbackground: #9cc4e8\nsphere { material: ";
  folder.write("a.rtl", scene + "tomato }\n");
  folder.write("b.rtl", scene + "teal, radius: 1.1 }\n");
  for (const char* name : {"a.png", "a.ppm", "a.exr"})
    REQUIRE(tests::rtlang({"a.rtl", "-q", "-o", name}, here).exit_code == 0);
  REQUIRE(tests::rtlang({"b.rtl", "-q", "-o", "b.exr"}, here).exit_code == 0);

  CHECK(tests::rtlang({"diff", "a.png", "a.ppm"}, here).exit_code == 0);
  CHECK(tests::rtlang({"diff", "a.png", "a.exr"}, here).exit_code == 1);
  CHECK(tests::rtlang({"diff", "a.png", "a.exr", "--gate", "equal_8bit=1"}, here).exit_code == 0);
  CHECK(tests::rtlang({"diff", "a.exr", "a.exr", "--gate", "objects=0", "--gate", "depth=0"}, here).exit_code == 0);
  const tests::Outcome differs =
      tests::rtlang({"diff", "a.exr", "b.exr", "--gate", "objects=0", "-o", "map.png"}, here);
  CHECK(differs.exit_code == 1);
  CHECK(differs.output.find("FAILS") != std::string::npos);
  CHECK_FALSE(folder.read("map.png").empty());
  CHECK(tests::rtlang({"diff", "a.png", "nothing.png"}, here).exit_code == 3);
  CHECK(tests::rtlang({"diff", "a.png"}, here).exit_code == 2);
}
