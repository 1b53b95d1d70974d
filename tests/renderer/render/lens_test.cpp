#include "renderer/render/camera_rays.hpp"
#include "renderer/render/estimate.hpp"
#include "renderer/render/pixel_filter.hpp"
#include "tests/support/estimates.hpp"

using namespace rt;
using namespace rt::tests;

namespace {

scene::Camera with_lens(scene::Projection projection = scene::Projection::perspective) {
  scene::Camera camera{.at = {0, 0, 0}, .look_at = {0, 0, -1}, .fov = 40, .projection = projection};
  camera.aperture = 0.2;
  camera.focus = 5;
  return camera;
}

} // namespace

TEST_CASE("lens: all rays of a place in the picture meet in the plane of focus") {
  for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
    const CameraRays camera(with_lens(projection), {400, 300});
    const Ray middle = camera.ray(120, 30);
    const Vec3 sharp = middle.at(5 / -middle.direction.z);
    double farthest = 0;
    for (std::uint32_t i = 0; i < 256; ++i) {
      const auto numbers = SampleStream(0, 0, 0, i).group(1);
      const Ray ray = camera.lens_ray(120, 30, numbers[0], numbers[1]);
      CHECK(length(ray.at(length(sharp - ray.origin)) - sharp) < 1e-14);
      CHECK(ray.origin.z == 0);
      farthest = std::max(farthest, length(ray.origin - middle.origin));
    }
    CHECK(farthest <= 0.1 + 1e-15);
    CHECK(farthest > 0.095);
  }
}

TEST_CASE("lens: the plane of focus passes through `focus_at`, or `look_at`") {
  scene::Camera camera = with_lens();
  camera.focus = std::nullopt;
  CHECK(scene::focus_distance(camera) == 1);
  camera.focus_at = Vec3{3, 4, -7};
  CHECK(scene::focus_distance(camera) == 7);
  camera.focus_at = Vec3{3, 4, 7};
  CHECK(check(camera)->field == "focus_at");
}

// At the distance D = 8 the rays of a place fill a disc of the radius 0.1·(8 − 5)/5 = 0.06. What of it lies beyond a
// straight edge x radii from its middle is ½ + (x·√(1 − x²) + asin x)/π.
TEST_CASE("lens: a straight edge that is out of focus") {
  SceneBuilder k;
  k.scene.camera = with_lens();
  scene::Quad half;
  half.corner = Vec3{0, -9, -8}, half.edge_u = Vec3{9, 0, 0}, half.edge_v = Vec3{0, 18, 0};
  k.add(k.shape(half).with(k.glow(1)));
  const CompiledScene scene(k.scene, 1);
  const CameraRays camera(k.scene.camera, {400, 400});
  const Estimator estimator(scene);
  const double pixel = 8 * std::tan(20 * std::numbers::pi / 180) / 200; // at this distance
  for (const auto& [beyond, expected] : {std::pair{0.0, 0.5}, {0.25, 0.6574812}, {0.5, 0.8044989}, {0.75, 0.9278532}}) {
    const double aside = beyond;
    const rt::Estimate seen = estimator.radiance(
        [&](const SampleStream& stream) {
          const auto lens = stream.group(lens_group);
          return camera.lens_ray(200 + aside * 0.06 / pixel, 200, lens[0], lens[1]);
        },
        4e-3);
    CHECK(std::abs(seen.mean.g - expected) <= 4.5 * seen.error + 1e-9);
    CHECK(seen.error <= 1e-3);
  }
}
