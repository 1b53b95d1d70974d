#include "renderer/scene/material.hpp"

#include <algorithm>

namespace rt::scene {
namespace {

constexpr std::string_view highlight_choices[] = {"blinn", "phong"};

} // namespace

std::span<const Field> fields(const Material*) {
  static constexpr Field table[] = {
      field<&Material::color>("color", {"white", "colour or pattern of the surface", not_negative}),
      field<&Material::ambient>("ambient", {"1", "fraction of the scene's ambient light that is reflected",
                                            not_negative, 0, FieldType::number}),
      field<&Material::diffuse>("diffuse", {"0.8", "fraction of light that is reflected diffusely (Lambert)",
                                            not_negative, 0, FieldType::number}),
      field<&Material::emission>("emission",
                                 {"0", "emitted light, in the surface's colour", not_negative, 0, FieldType::number}),
      field<&Material::specular>("specular", {"0", "strength of the highlight", not_negative}),
      field<&Material::shininess>("shininess",
                                  {"32", "exponent of the highlight: the higher, the smaller the highlight", positive}),
      field<&Material::highlight>("highlight", {"blinn", "blinn: half-way vector; phong: reflection vector", any_value,
                                                0, std::nullopt, highlight_choices}),
      field<&Material::metallic>(
          "metallic",
          {"0", "how much highlights and reflections are tinted by the surface's colour, 0 to 1", zero_to_one}),
      field<&Material::reflect>("reflect", {"0", "weight of the reflected ray", not_negative}),
      field<&Material::refract>("refract", {"0", "weight of the refracted ray, 0 (opaque) to 1", zero_to_one}),
      field<&Material::ior>("ior", {.default_text = "1",
                                    .help = "index of refraction of the interior",
                                    .constraint = positive,
                                    .constant_because = "a solid is a single medium with one index of refraction"}),
      field<&Material::fresnel>("fresnel",
                                {"false", "weights of reflection and refraction follow Fresnel's equations"}),
      field<&Material::roughness>("roughness", {.default_text = "",
                                                .help = "0 (smooth) to 1; `shininess` defaults to 2/roughness⁴ − 2",
                                                .constraint = zero_to_one}),
      field<&Material::metal>("metal", {.default_text = "",
                                        .help = "complex index of refraction n + ik of a metal; sets the defaults of "
                                                "`reflect` (its reflectance at normal incidence) and `metallic` (1)"}),
      field<&Material::coat>("coat",
                             {"0", "weight of a clear coat that reflects by Fresnel's equations, 0 to 1", zero_to_one}),
      field<&Material::coat_roughness>("coat_roughness", {.default_text = "0",
                                                          .help = "roughness of the coat",
                                                          .constraint = zero_to_one,
                                                          .constant_because = "a coat is equally rough all over"}),
      field<&Material::coat_ior>("coat_ior", {.default_text = "1.5",
                                              .help = "index of refraction of the coat",
                                              .constraint = positive,
                                              .constant_because = "a coat has one index of refraction"}),
      field<&Material::absorb>(
          "absorb", {.default_text = "",
                     .help = "absorption: the colour of white light after travelling `distance` through the interior"}),
      field<&Material::thin>(
          "thin",
          {"false", "a thin sheet rather than a solid: transmitted light is not bent, and there is no interior"}),
      field<&Material::bump>("bump",
                             {"0", "a pattern of heights, in lengths of the object: bends the normal", not_negative}),
  };
  return table;
}

Color normal_reflectance(const Metal& metal) {
  const auto reflectance = [](double n, double k) { return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k); };
  return {reflectance(metal.n.r, metal.k.r), reflectance(metal.n.g, metal.k.g), reflectance(metal.n.b, metal.k.b)};
}

// Clamped to what a highlight allows: no roughness at all would make it a point, the greatest would remove it.
double shininess_of(double roughness) {
  const double square = roughness * roughness;
  return std::clamp(2 / std::max(square * square, 1e-12) - 2, 0.01, 1e6);
}

Material with_implied(Material m) {
  if (m.metal && !m.reflect.is_written()) m.reflect = normal_reflectance(*m.metal);
  if (m.metal && !m.metallic.is_written()) m.metallic = 1.0;
  const double* roughness = m.roughness ? std::get_if<double>(&*m.roughness) : nullptr;
  if (roughness && !m.shininess.is_written()) m.shininess = shininess_of(*roughness);
  return m;
}

} // namespace rt::scene
