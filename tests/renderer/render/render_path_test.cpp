#include "renderer/render/render.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

namespace {

// A lamp with a size over a ball on a plane, in front of a sky that shows through the picture's upper part.
scene::Scene lamp_and_ball() {
  tests::SceneBuilder k;
  k.scene.mode = scene::Mode::path;
  k.scene.size = {40, 24};
  k.scene.samples = 20;
  k.scene.background = {0.1, 0.2, 0.3};
  k.scene.camera.at = {0, 1, 6};
  k.scene.camera.look_at = {0, 1, 0};
  k.add(k.sphere().at({0, 1, 0}).with(k.material(Color{1, 0.2, 0.1})));
  k.add(k.shape(scene::Plane{}));
  k.add(k.shape(scene::Disc{}).at({1, 4, 1}).with(k.glow(3)));
  return std::move(k.scene);
}

std::vector<Rgb32> picture(const scene::Scene& scene, int threads = 1, std::optional<PixelRect> crop = {}) {
  RenderOptions options;
  options.threads = threads;
  options.crop = crop;
  return render(scene, options).film.color;
}

bool is_same(const Rgb32& a, const Rgb32& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

std::size_t differences(const std::vector<Rgb32>& a, const std::vector<Rgb32>& b) {
  REQUIRE(a.size() == b.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += is_same(a[i], b[i]) ? 0 : 1;
  return count;
}

} // namespace

TEST_CASE("render in path mode: any number of threads gives the same bytes") {
  const scene::Scene scene = lamp_and_ball();
  const auto one = picture(scene);
  for (const int threads : {2, 3, 8}) CHECK(differences(one, picture(scene, threads)) == 0);
}

TEST_CASE("render in path mode: a part has the bytes of the whole, however its tiles fall") {
  const scene::Scene scene = lamp_and_ball();
  const auto whole = picture(scene);
  const PixelRect crop{3, 5, 24, 21};
  const auto part = picture(scene, 2, crop);
  for (int y = crop.y0; y < crop.y1; ++y)
    for (int x = crop.x0; x < crop.x1; ++x)
      CHECK(is_same(part[static_cast<std::size_t>((y - crop.y0) * crop.width() + x - crop.x0)],
                    whole[static_cast<std::size_t>(y * 40 + x)]));
}

TEST_CASE("render in path mode: another seed changes every noisy pixel and no exact one") {
  scene::Scene scene = lamp_and_ball();
  const auto one = picture(scene);
  scene.seed = 1;
  const auto other = picture(scene);
  // The first rows see the sky alone.
  CHECK(differences({one.begin(), one.begin() + 80}, {other.begin(), other.begin() + 80}) == 0);
  CHECK(one[0].b == Approx(0.3));
  // The last ones see the plane, and its shadows are soft.
  CHECK(differences({one.end() - 80, one.end()}, {other.end() - 80, other.end()}) == 80);
}

// Over the whole picture the error falls as fast as points that are drawn at random let it, or faster: from 4 samples
// to 64 by four.
TEST_CASE("render in path mode: more samples, less noise, the same mean") {
  scene::Scene scene = lamp_and_ball();
  const auto at = [&](int samples, int seed) {
    scene.samples = samples;
    scene.seed = seed;
    return picture(scene, 2);
  };
  const auto reference = at(512, 9);
  const auto error = [&](const std::vector<Rgb32>& film) {
    double sum = 0;
    for (std::size_t i = 0; i < film.size(); ++i) sum += std::pow(film[i].g - reference[i].g, 2);
    return std::sqrt(sum / static_cast<double>(film.size()));
  };
  CHECK(error(at(64, 1)) < error(at(4, 1)) / 3.5);
}

TEST_CASE("render in path mode: filters spread pixels, and the box keeps them apart") {
  tests::SceneBuilder k;
  k.scene.mode = scene::Mode::path;
  k.scene.size = {8, 8};
  k.scene.samples = 256;
  k.scene.camera = {.at = {0, 0, 5}, .projection = scene::Projection::orthographic, .width = 8};
  scene::Quad half; // the left half of the picture
  half.corner = Vec3{-4, -4, 0}, half.edge_u = Vec3{4, 0, 0}, half.edge_v = Vec3{0, 8, 0};
  k.add(k.shape(half).with(k.glow(1)));
  k.scene.filter = scene::PixelFilter::box;
  const auto box = picture(k.scene);
  CHECK(box[8 * 4 + 3].g == 1);
  CHECK(box[8 * 4 + 4].g == 0);
  // Beside the edge a pixel gets what of the filter lies beyond half a pixel, by quadrature: of Blackman and Harris's
  // window over ±1.5 pixels, and of the Gaussian exp(−2x²) less its value there.
  for (const auto& [filter, expected] :
       {std::pair{scene::PixelFilter::gaussian, 0.152921}, {scene::PixelFilter::blackman_harris, 0.118592}}) {
    k.scene.filter = filter;
    const auto blurred = picture(k.scene);
    double mean = 0; // of a column
    for (std::size_t y = 2; y < 6; ++y) mean += blurred[8 * y + 4].g / 4;
    CHECK(mean == Approx(expected).margin(0.004));
    CHECK(blurred[8 * 4 + 6].g == 0);
  }
}

// Stopped wherever that happens to be, and continued, also where blocks of pixels rest that are quiet enough.
TEST_CASE("render in path mode: what was stopped and is continued has the bytes of what was not") {
  scene::Scene scene = lamp_and_ball();
  scene.samples = 512;
  for (const double noise : {0.0, 0.02}) {
    if (noise > 0) scene.noise = noise;
    RenderOptions whole;
    whole.sums = true;
    const Rendered expected = render(scene, whole);
    for (const double share : {0.02, 0.2, 0.35}) {
      std::atomic<bool> stop = false;
      RenderOptions options;
      options.sums = true, options.threads = 2, options.stop = &stop;
      options.on_tile = [&, tiles = 0](const Film&, const PixelRect&) mutable { stop = ++tiles >= share * 12; };
      const Rendered begun = render(scene, options);
      REQUIRE_FALSE(begun.is_complete);
      RenderOptions rest;
      rest.sums = true, rest.earlier = &begun.film;
      const Rendered ended = render(scene, rest);
      CHECK(differences(ended.film.color, expected.film.color) == 0);
      CHECK(ended.film.sums == expected.film.sums);
      CHECK(ended.film.noise_states == expected.film.noise_states);
      CHECK(ended.statistics.samples == expected.statistics.samples);
    }
    if (noise > 0) CHECK(expected.statistics.samples < 512);
  }
}

// Of 20 samples the first of three parts has 0, 1, 6, 7, 12, 13, 18 and 19, the others six each.
TEST_CASE("render in path mode: parts add up to the whole") {
  const scene::Scene scene = lamp_and_ball();
  RenderOptions options;
  options.sums = true;
  const Rendered whole = render(scene, options);
  std::vector<PixelSums> sum(whole.film.sums.size());
  for (const int k : {3, 1, 2}) {
    options.part = {k, 3};
    const Rendered part = render(scene, options);
    CHECK(part.statistics.samples == (k == 1 ? 8 : 6));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i].add(part.film.sums[i]);
  }
  CHECK(sum == whole.film.sums);
}

TEST_CASE("render in path mode: it can be stopped, and says so") {
  scene::Scene scene = lamp_and_ball();
  scene.samples = 65536;
  std::atomic<bool> stop = false;
  RenderOptions options;
  options.stop = &stop;
  options.on_progress = [&](const Progress& progress) { stop = progress.fraction > 0.0001; };
  CHECK_FALSE(render(scene, options).is_complete);
}
