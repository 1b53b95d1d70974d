#include "renderer/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rt::scene {
namespace {

constexpr std::string_view highlight_choices[] = {"blinn", "phong"};
constexpr std::string_view projection_choices[] = {"perspective", "orthographic"};

} // namespace

std::span<const Field> material_fields() {
  static constexpr Field table[] = {
      field<&Material::color>("color", {"white", "colour or pattern of the surface", not_negative}),
      field<&Material::ambient>("ambient", {"1", "share of the scene's ambient light that is given back", not_negative,
                                            0, FieldType::number_paint}),
      field<&Material::diffuse>(
          "diffuse", {"0.8", "share of a light that is scattered (Lambert)", not_negative, 0, FieldType::number_paint}),
      field<&Material::emission>("emission", {"0", "light given off without any lamp, in the surface's colour",
                                              not_negative, 0, FieldType::number_paint}),
      field<&Material::specular>("specular", {"0", "strength of the highlight", not_negative}),
      field<&Material::shininess>("shininess", {"32", "exponent of the highlight: the higher, the smaller", positive}),
      field<&Material::highlight>("highlight", {"blinn", "blinn: half-way vector; phong: mirrored light vector",
                                                any_value, 0, std::nullopt, highlight_choices}),
      field<&Material::metallic>("metallic",
                                 {"0", "how much highlight and mirror take the surface's colour, 0 to 1", zero_to_one}),
      field<&Material::reflect>("reflect", {"0", "weight of the mirrored ray, a number or a colour", not_negative}),
      field<&Material::refract>("refract", {"0", "weight of the refracted ray, 0 (opaque) to 1", zero_to_one}),
      field<&Material::ior>("ior", {"1", "index of refraction of the inside", positive}),
      field<&Material::fresnel>("fresnel", {"false", "weights of mirror and refraction follow Fresnel's equations"}),
  };
  return table;
}

std::span<const Field> pattern_fields() {
  static constexpr Field table[] = {
      field<&Pattern::a>("a", {"white", "first colour, number or pattern", not_negative}),
      field<&Pattern::b>("b", {"black", "second colour, number or pattern", not_negative}),
  };
  return table;
}

std::span<const Field> fields(const PointLight*) {
  static constexpr Field table[] = {
      field<&PointLight::at>("at", {"[0, 0, 0]", "position"}),
      field<&PointLight::color>("color", {"white", "colour of the light", not_negative}),
      field<&PointLight::intensity>("intensity", {"1", "factor on the colour", not_negative}),
      field<&PointLight::fade>("fade",
                               {"none", "linear(d), quadratic(d) or inverse_square: how it weakens with distance"}),
      field<&PointLight::shadows>("shadows", {"true", "false: nothing blocks it and it makes no highlight"}),
  };
  return table;
}

std::span<const Field> fields(const SunLight*) {
  static constexpr Field table[] = {
      field<&SunLight::direction>("direction", {"[-1, -2, -1]", "the way its light travels", nonzero}),
      field<&SunLight::color>("color", {"white", "colour of the light", not_negative}),
      field<&SunLight::intensity>("intensity", {"1", "factor on the colour", not_negative}),
      field<&SunLight::shadows>("shadows", {"true", "false: nothing blocks it and it makes no highlight"}),
  };
  return table;
}

std::span<const Field> fields(const SpotLight*) {
  static constexpr Constraint cone{.min = 0, .max = 180, .min_is_excluded = true, .max_is_excluded = true};
  static constexpr Field table[] = {
      field<&SpotLight::at>("at", {"[0, 3, 0]", "position"}),
      field<&SpotLight::look_at>("look_at", {"[0, 0, 0]", "point on the axis of the cone"}),
      field<&SpotLight::angle>("angle", {"40", "full angle of the cone of full light, degrees", cone}),
      field<&SpotLight::falloff>("falloff",
                                 {"angle", "full angle of the cone outside of which there is no light, degrees", cone}),
      field<&SpotLight::color>("color", {"white", "colour of the light", not_negative}),
      field<&SpotLight::intensity>("intensity", {"1", "factor on the colour", not_negative}),
      field<&SpotLight::fade>("fade",
                              {"none", "linear(d), quadratic(d) or inverse_square: how it weakens with distance"}),
      field<&SpotLight::shadows>("shadows", {"true", "false: nothing blocks it and it makes no highlight"}),
  };
  return table;
}

std::optional<Problem> check(const PointLight&) {
  return std::nullopt;
}
std::optional<Problem> check(const SunLight&) {
  return std::nullopt;
}
std::optional<Problem> check(const SpotLight& light) {
  if (light.at == light.look_at)
    return Problem{"look_at", "a spot needs a direction: `look_at` is where it stands (`at`)"};
  if (light.falloff && *light.falloff < light.angle)
    return Problem{"falloff", "`falloff` is the outer cone: it must not be smaller than `angle`"};
  return std::nullopt;
}

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
  };
  return table;
}

std::optional<Problem> check(const Camera& camera) {
  if (camera.at == camera.look_at)
    return Problem{"look_at", "the camera needs a direction: `look_at` is where it stands (`at`)"};
  const Vec3 f = camera.look_at - camera.at;
  if (length(cross(f, camera.up)) <= 1e-12 * length(f) * length(camera.up)) {
    // Seen from straight above, what is far away for a camera at its default place is at the top.
    const bool is_vertical = std::abs(f.y) > std::max(std::abs(f.x), std::abs(f.z));
    return Problem{"up", "`up` is parallel to the view, so it does not say what is up in the picture",
                   std::string("write another direction, for instance `up: ") +
                       (is_vertical ? "[0, 0, -1]`" : "[0, 1, 0]`")};
  }
  return std::nullopt;
}

std::span<const Field> fields(const Scene*) {
  static constexpr Constraint pixels{.min = 1, .max = 65536, .is_whole = true};
  static constexpr Constraint depth{.min = 0, .max = 1000, .is_whole = true};
  static constexpr Constraint count{.min = 1, .max = 65536, .is_whole = true};
  static constexpr Field table[] = {
      field<&Scene::size>("size", {"[800, 600]", "width and height of the picture in pixels", pixels}),
      field<&Scene::background>("background", {"black", "colour of a ray that hits nothing", not_negative}),
      field<&Scene::ambient>("ambient", {"0.1", "light that is everywhere, a number or a colour", not_negative}),
      field<&Scene::max_depth>("max_depth", {"8", "how often a ray may be mirrored or refracted", depth}),
      field<&Scene::samples>("samples", {"1", "rays for each pixel, a square number: a regular grid", count}),
  };
  return table;
}

std::optional<int> sample_grid(int samples) {
  const int side = static_cast<int>(std::lround(std::sqrt(std::max(samples, 0))));
  if (side == 0 || side * side != samples) return std::nullopt;
  return side;
}

std::optional<Problem> check(const Scene& scene) {
  if (!sample_grid(scene.samples))
    return Problem{"samples", "`samples` is a grid of n × n rays: write a square number (1, 4, 9, 16, …)"};
  return std::nullopt;
}

} // namespace rt::scene
