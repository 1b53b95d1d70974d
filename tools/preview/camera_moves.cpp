#include "tools/preview/camera_moves.hpp"

#include "renderer/math/format_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rt::tools::preview {
namespace {

constexpr double degree = std::numbers::pi / 180;

std::string text_of(const Vec3& v) {
  return fmt::format("[{}, {}, {}]", format_number(v.x), format_number(v.y), format_number(v.z));
}

/// For the kinds of values that a camera has; empty for others.
std::string text_of(const scene::Field& field, const scene::FieldValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number);
  if (const auto* vector = std::get_if<Vec3>(&value)) return text_of(*vector);
  if (const auto* choice = std::get_if<scene::Choice>(&value))
    return std::string(field.choices[static_cast<std::size_t>(choice->index)]);
  return "";
}

} // namespace

scene::Camera orbited(const scene::Camera& camera, double right, double up) {
  const Vec3 axis = normalize(camera.up), to_eye = camera.at - camera.look_at;
  const double height = dot(to_eye, axis);
  const Vec3 level = to_eye - axis * height;
  const double elevation = std::atan2(height, length(level));
  const double raised = std::clamp(elevation + up * degree, std::min(elevation, -89 * degree),
                                   std::max(elevation, 89 * degree)); // a view from nearer the pole may stay there
  const Vec3 ahead = normalize(level), aside = cross(axis, ahead);
  const Vec3 turned = ahead * std::cos(right * degree) + aside * std::sin(right * degree);
  scene::Camera moved = camera;
  moved.at = camera.look_at + (turned * std::cos(raised) + axis * std::sin(raised)) * length(to_eye);
  return moved;
}

scene::Camera panned(const scene::Camera& camera, double right, double up) {
  const Vec3 view = camera.look_at - camera.at, forward = normalize(view);
  const Vec3 aside = normalize(cross(forward, camera.up)), upwards = cross(aside, forward);
  const bool has_eye = camera.projection == scene::Projection::perspective;
  const double width = has_eye ? 2 * std::tan(camera.fov / 2 * degree) * length(view) : camera.width;
  const Vec3 step = (aside * right + upwards * up) * width;
  scene::Camera moved = camera;
  moved.at += step;
  moved.look_at += step;
  return moved;
}

scene::Camera zoomed(const scene::Camera& camera, double factor) {
  scene::Camera moved = camera;
  moved.at = camera.look_at + (camera.at - camera.look_at) * factor;
  moved.width *= factor;
  return moved;
}

std::string camera_text(const scene::Camera& camera) {
  std::string text = fmt::format("camera {{ at: {}, look_at: {}", text_of(camera.at), text_of(camera.look_at));
  const scene::Camera standard;
  for (const scene::Field& field : fields(&camera)) {
    if (field.name == "at" || field.name == "look_at") continue;
    const auto value = field.get(&camera), usual = field.get(&standard);
    if (!value) continue;
    const std::string written = text_of(field, *value);
    if (!usual || text_of(field, *usual) != written) text += fmt::format(", {}: {}", field.name, written);
  }
  return text + " }";
}

} // namespace rt::tools::preview
