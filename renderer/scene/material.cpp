#include "renderer/scene/material.hpp"

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
  };
  return table;
}

} // namespace rt::scene
