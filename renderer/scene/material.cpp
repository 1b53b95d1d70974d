#include "renderer/scene/material.hpp"

#include <algorithm>

namespace rt::scene {
namespace {

constexpr std::string_view highlight_choices[] = {"blinn", "phong"};

} // namespace

std::span<const Field> fields(const Material*) {
  static constexpr Field table[] = {
      field<&Material::color>("color", {"white", "colour or pattern of the surface", not_negative}),
      field<&Material::ambient>("ambient", {"1", "share of the scene's ambient light that is given back", not_negative,
                                            0, FieldType::number}),
      field<&Material::diffuse>(
          "diffuse", {"0.8", "share of a light that is scattered (Lambert)", not_negative, 0, FieldType::number}),
      field<&Material::emission>("emission", {"0", "light given off without any lamp, in the surface's colour",
                                              not_negative, 0, FieldType::number}),
      field<&Material::specular>("specular", {"0", "strength of the highlight", not_negative}),
      field<&Material::shininess>("shininess", {"32", "exponent of the highlight: the higher, the smaller", positive}),
      field<&Material::highlight>("highlight", {"blinn", "blinn: half-way vector; phong: mirrored light vector",
                                                any_value, 0, std::nullopt, highlight_choices}),
      field<&Material::metallic>("metallic",
                                 {"0", "how much highlight and mirror take the surface's colour, 0 to 1", zero_to_one}),
      field<&Material::reflect>("reflect", {"0", "weight of the mirrored ray", not_negative}),
      field<&Material::refract>("refract", {"0", "weight of the refracted ray, 0 (opaque) to 1", zero_to_one}),
      field<&Material::ior>(
          "ior", {.default_text = "1",
                  .help = "index of refraction of the inside",
                  .constraint = positive,
                  .constant_because = "one solid is one medium, and its index of refraction is the same all over"}),
      field<&Material::fresnel>("fresnel", {"false", "weights of mirror and refraction follow Fresnel's equations"}),
      field<&Material::roughness>("roughness",
                                  {.default_text = "",
                                   .help = "0 (smooth) to 1; `shininess` is 2/roughness⁴ − 2 unless written",
                                   .constraint = zero_to_one}),
      field<&Material::metal>("metal",
                              {.default_text = "",
                               .help = "what its colour comes from: index of refraction n + ik; unless written "
                                       "`reflect` is what it mirrors at the normal and `metallic` is 1"}),
      field<&Material::coat>("coat",
                             {"0", "weight of a clear layer that mirrors by Fresnel's equations, 0 to 1", zero_to_one}),
      field<&Material::coat_roughness>("coat_roughness", {.default_text = "0",
                                                          .help = "of that layer, as `roughness`",
                                                          .constraint = zero_to_one,
                                                          .constant_because = "a coat is equally rough all over"}),
      field<&Material::coat_ior>("coat_ior", {.default_text = "1.5",
                                              .help = "index of refraction of that layer",
                                              .constraint = positive,
                                              .constant_because = "a coat has one index of refraction"}),
      field<&Material::absorb>(
          "absorb", {.default_text = "", .help = "what the inside leaves of white light that goes so far through it"}),
      field<&Material::thin>("thin",
                             {"false", "a sheet, not a solid: what passes is not bent, and there is no inside"}),
      field<&Material::bump>("bump",
                             {"0", "a pattern of heights, in lengths of the object: bends the normal", not_negative}),
  };
  return table;
}

Color normal_reflectance(const Metal& metal) {
  const auto reflectance = [](double n, double k) { return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k); };
  return {reflectance(metal.n.r, metal.k.r), reflectance(metal.n.g, metal.k.g), reflectance(metal.n.b, metal.k.b)};
}

// Within what a highlight takes: no roughness at all would make it a point, the greatest none at all.
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
