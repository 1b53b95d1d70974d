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
      field<&Camera::look_at>("look_at", {"[0, 0, 0]", "point in the middle of the picture"}),
      field<&Camera::up>("up", {"[0, 1, 0]", "the direction that is up in the picture", nonzero}),
      field<&Camera::fov>("fov", {"50", "horizontal angle of view, degrees", view}),
      field<&Camera::projection>(
          "projection", {"perspective", "perspective or orthographic", any_value, 0, std::nullopt, projection_choices}),
      field<&Camera::width>("width", {"4", "width of an orthographic view", positive}),
      field<&Camera::aperture>("aperture", {"0", "in path: diameter of the lens; 0 is sharp everywhere", not_negative}),
      field<&Camera::focus_at>("focus_at",
                               {"", "in path: a point in the plane that is sharp; else `look_at`", any_value, 1}),
      field<&Camera::focus>("focus", {"", "in path: the distance of that plane", positive, 2}),
  };
  return table;
}

std::optional<Problem> check(const Camera& camera) {
  if (camera.at == camera.look_at)
    return Problem{"look_at", "the camera needs a direction: `look_at` is where it stands (`at`)"};
  const Vec3 f = camera.look_at - camera.at;
  if (length(cross(f, camera.up)) <= 1e-12 * length(f) * length(camera.up)) {
    // Seen from straight above, what is far away for a camera at its default position is at the top.
    const bool is_vertical = std::abs(f.y) > std::max(std::abs(f.x), std::abs(f.z));
    return Problem{"up", "`up` is parallel to the view, so it does not say what is up in the picture",
                   std::string("write another direction, for instance `up: ") +
                       (is_vertical ? "[0, 0, -1]`" : "[0, 1, 0]`")};
  }
  if (!(focus_distance(camera) > 0))
    return Problem{"focus_at", "`focus_at` is not before the camera: nothing there can be sharp"};
  return std::nullopt;
}

double focus_distance(const Camera& camera) {
  if (camera.focus) return *camera.focus;
  return dot(camera.focus_at.value_or(camera.look_at) - camera.at, normalize(camera.look_at - camera.at));
}

} // namespace rt::scene
