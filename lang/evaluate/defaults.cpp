#include "lang/evaluate/defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::lang {
namespace {

constexpr Vec3 towards_the_eye{0.5, 0.45, 1};
constexpr double margin = 1.1;

std::string text(const Vec3& v) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x, v.y, v.z);
}

} // namespace

scene::Camera framing_camera(const scene::Scene& scene) {
  return framing_camera(scene::finite_bounds(scene), scene.size);
}

scene::Camera framing_camera(const Box3& box, scene::Resolution size) {
  scene::Camera camera;
  if (box.is_empty()) return camera;
  const double radius = length(box.extent()) / 2;
  const double across = std::tan(camera.fov / 2 * (std::numbers::pi / 180));
  const double aspect = static_cast<double>(size[0]) / size[1];
  const double half_angle = std::atan(std::min(across, across / aspect));
  const Vec3 eye = box.center() + normalize(towards_the_eye) * (margin * radius / std::sin(half_angle));
  if (!is_finite(eye) || eye == box.center()) return camera;
  camera.at = eye;
  camera.look_at = box.center();
  return camera;
}

scene::Light key_sun() {
  scene::Light light;
  light.source = scene::SunLight{{}, {-1, -2, -1.5}};
  return light;
}

std::string describe_camera(const scene::Camera& camera) {
  return fmt::format("looking from {} at {}", text(camera.at), text(camera.look_at));
}

std::string describe_sun(const scene::Light& light) {
  return fmt::format("a sun shines along {}", text(std::get<scene::SunLight>(light.source).direction));
}

} // namespace rt::lang
