#include "renderer/scene/defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::scene {
namespace {

constexpr Vec3 towards_the_eye{0.5, 0.45, 1};
constexpr double margin = 1.1;

std::string text(const Vec3& v) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x, v.y, v.z);
}

Camera framing_camera(const Box3& box, Resolution size) {
  Camera camera;
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

} // namespace

std::string assume_camera(Scene& scene, const Box3& finite_bounds) {
  scene.camera = framing_camera(finite_bounds, scene.size);
  return fmt::format("no camera given: using one at {} looking at {}", text(scene.camera.at),
                     text(scene.camera.look_at));
}

bool lacks_light(const Scene& scene, bool has_ambient) {
  if (std::any_of(scene.lights.begin(), scene.lights.end(), is_lamp)) return false;
  if (scene.mode == Mode::occlusion) return false;
  if (!scene.is_path()) return !has_ambient;
  if (!scene.lights.empty()) return false;
  const auto& materials = scene.materials;
  return scene.background == black && std::none_of(materials.begin(), materials.end(), shines);
}

std::string assume_light(Scene& scene) {
  SunLight sun;
  sun.direction = {-1, -2, -1.5};
  scene.lights.push_back({sun, {}, {}, no_name, {}});
  return fmt::format("no light given: added a sun with direction {}", text(sun.direction));
}

} // namespace rt::scene
