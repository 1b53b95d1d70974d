#include "renderer/scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rt::scene {
namespace {

constexpr std::string_view projection_choices[] = {"perspective", "orthographic"};

} // namespace

std::span<const Field> fields(const Camera*) {
  static constexpr Constraint view{.min = 0, .max = 180, .min_is_excluded = true, .max_is_excluded = true};
  static constexpr Field table[] = {
      field<&Camera::at>("at", {"[0, 1, 6]", "position of the eye"}),
      field<&Camera::look_at>("look_at", {"[0, 0, 0]", "point at the centre of the picture"}),
      field<&Camera::up>("up", {"[0, 1, 0]", "the up direction of the picture", nonzero}),
      field<&Camera::fov>("fov", {"50", "horizontal angle of view, degrees", view}),
      field<&Camera::projection>(
          "projection", {"perspective", "perspective or orthographic", any_value, 0, std::nullopt, projection_choices}),
      field<&Camera::width>("width", {"4", "width of an orthographic view", positive}),
      field<&Camera::aperture>("aperture",
                               {"0", "in path mode: lens diameter; 0: everything is in focus", not_negative}),
      field<&Camera::focus_at>(
          "focus_at", {"", "in path mode: a point on the plane of focus; defaults to `look_at`", any_value, 1}),
      field<&Camera::focus>("focus", {"", "in path mode: the focus distance", positive, 2}),
  };
  return table;
}

std::optional<Problem> check(const Camera& camera) {
  if (camera.at == camera.look_at)
    return Problem{"look_at", "the camera needs a direction: `look_at` equals its position `at`"};
  const Vec3 f = camera.look_at - camera.at;
  if (length(cross(f, camera.up)) <= 1e-12 * length(f) * length(camera.up)) {
    // Seen from straight above, what is far away for a camera at its default position is at the top.
    const bool is_vertical = std::abs(f.y) > std::max(std::abs(f.x), std::abs(f.z));
    return Problem{"up", "`up` is parallel to the view direction, so the up direction of the picture is undefined",
                   std::string("write another direction, for instance `up: ") +
                       (is_vertical ? "[0, 0, -1]`" : "[0, 1, 0]`")};
  }
  if (!(focus_distance(camera) > 0))
    return Problem{"focus_at", "`focus_at` is not in front of the camera: nothing there can be in focus"};
  return std::nullopt;
}

double focus_distance(const Camera& camera) {
  if (camera.focus) return *camera.focus;
  return dot(camera.focus_at.value_or(camera.look_at) - camera.at, normalize(camera.look_at - camera.at));
}

} // namespace rt::scene
