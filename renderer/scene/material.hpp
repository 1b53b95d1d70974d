#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Index of a material in `Scene::materials`; `no_material` inherits the enclosing composite's, in the end the default.
enum class MaterialId : std::uint32_t {};
inline constexpr MaterialId no_material{0xffffffff};

enum class Highlight : std::uint8_t { blinn, phong };

/// The complex index of refraction n + ik of a metal, for each channel.
struct Metal {
  Color n = white, k = black;
  friend bool operator==(const Metal&, const Metal&) = default;
};

/// The surface and, through `ior`, the inside of a solid: Whitted's model (An Improved Illumination Model for Shaded
/// Display, 1980) with ambient, emission, metallic tint and Fresnel. The default material is a white matte.
struct Material {
  Paint color = white;
  Paint ambient = grey(1);
  Paint diffuse = grey(0.8);
  Paint emission = grey(0);
  NumberPaint specular = 0.0;
  NumberPaint shininess = 32.0;
  Highlight highlight = Highlight::blinn;
  NumberPaint metallic = 0.0;
  Paint reflect = black;
  NumberPaint refract = 0.0;
  double ior = 1;
  bool fresnel = false;
  friend bool operator==(const Material&, const Material&) = default;
};

std::span<const Field> fields(const Material*);

/// Whether it lets no light through anywhere. Where a pattern says how much it lets through, it may.
inline bool is_opaque(const Material& material) {
  const double* refract = std::get_if<double>(&material.refract);
  return refract && *refract == 0;
}

/// Whether it gives off light somewhere. Where a pattern says how much, it may.
inline bool shines(const Material& material) {
  const Color* emission = std::get_if<Color>(&material.emission);
  return !emission || *emission != black;
}

} // namespace rt::scene
