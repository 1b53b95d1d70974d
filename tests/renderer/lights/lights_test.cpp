#include "renderer/lights/point.hpp"
#include "renderer/lights/spot.hpp"
#include "renderer/lights/sun.hpp"
#include "renderer/shading/lights.hpp"
#include "tests/support/shapes.hpp"

#include <cmath>

using namespace rt;
using rt::tests::near;
using Law = scene::Fade::Law;

TEST_CASE("lights: how light weakens with distance") {
  // At the law's own distance, and at three times it.
  CHECK(fade_at({Law::none, 2}, 6) == 1);
  CHECK(fade_at({Law::linear, 2}, 2) == 0.5);
  CHECK(fade_at({Law::linear, 2}, 6) == 0.25);
  CHECK(fade_at({Law::quadratic, 2}, 2) == 0.5);
  CHECK(fade_at({Law::quadratic, 2}, 6) == Approx(0.1));
  CHECK(fade_at({Law::inverse_square, 1}, 5) == Approx(0.04));
}

TEST_CASE("point light: where it stands, how far, how much is left") {
  scene::PointLight light;
  light.at = {0, 3, 4}, light.fade = {Law::linear, 5};
  const LightSample sample = sample_light(placed(light, {}), {0, 0, 0}); // 3² + 4² = 5²
  CHECK(sample.distance == 5);
  CHECK(near(sample.to_light, {0, 0.6, 0.8}));
  CHECK(sample.fade == 0.5);
  CHECK(sample.spot == 1);
  CHECK(placed(light, Affine::translating({1, 0, 0})).at == Vec3{1, 3, 4});
}

TEST_CASE("sun: the same from everywhere, whatever its transform does to lengths") {
  scene::SunLight light;
  light.direction = {0, -2, 0};
  const SunEmitter sun = placed(light, Affine::scaling({3, 5, 3}));
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1e6, -2, 7}}) {
    const LightSample sample = sample_light(sun, p);
    CHECK(sample.to_light == Vec3{0, 1, 0});
    CHECK(std::isinf(sample.distance));
    CHECK((sample.fade == 1 && sample.spot == 1));
  }
}

TEST_CASE("spot: full light in the inner cone, none outside the outer one, a smoothstep of the cosine between") {
  scene::SpotLight light;
  light.at = {0, 0, 0}, light.look_at = {0, -2, 0}, light.angle = 60, light.falloff = 120;
  const SpotEmitter spot = placed(light, {});
  const auto at = [&](double degrees) {
    const double a = degrees / 180 * 3.14159265358979323846;
    return sample_light(spot, Vec3{std::sin(a), -std::cos(a), 0} * 7).spot;
  };
  CHECK(at(0) == 1);
  CHECK(at(29.9) == 1);
  CHECK(at(60.1) == 0);
  CHECK(at(180) == 0);
  // The cosine half-way between those of 30° and 60°, (√3/2 + 1/2)/2: half of the light.
  CHECK(at(std::acos((std::sqrt(3) + 1) / 4) * 180 / 3.14159265358979323846) == Approx(0.5));
  // A quarter of the way: 3/16 − 2/64 = 5/32.
  CHECK(at(std::acos(0.5 + (std::sqrt(3) - 1) / 8) * 180 / 3.14159265358979323846) == Approx(5.0 / 32));
}

TEST_CASE("lights: a light of the scene has its colour times its intensity, weakened") {
  scene::SpotLight spot;
  spot.at = {0, 2, 0}, spot.color = {1, 0.5, 0.25}, spot.intensity = 8, spot.fade = {Law::inverse_square, 1};
  const Light light = make_light({spot, {scene::MoveStep{{0, 0, 3}}}, {}, scene::no_name, {}});
  CHECK(position(light) == Vec3{0, 2, 3});
  const LightSample sample = sample_light(light, {0, 0, 3});
  CHECK(sample.distance == 2);
  CHECK(sample.color == Color{2, 1, 0.5});
  CHECK_FALSE(position(make_light({scene::SunLight{}, {}, {}, scene::no_name, {}})));
}
