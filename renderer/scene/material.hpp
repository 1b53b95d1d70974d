#pragma once

#include "renderer/fields/field.hpp"

namespace rt::scene {

/// Index of a material in `Scene::materials`; `no_material` inherits the enclosing composite's, ultimately the default.
enum class MaterialId : std::uint32_t {};
inline constexpr MaterialId no_material{0xffffffff};

enum class Highlight : std::uint8_t { blinn, phong };

/// The surface and, through `ior`, the interior of a solid: Whitted's model (An Improved Illumination Model for Shaded
/// Display, 1980) with ambient, emission, metallic tint and Fresnel. The default material is matte white.
struct Material {
  Paint color = white;
  Paint ambient = grey(1);
  Paint diffuse = grey(0.8);
  Paint emission = grey(0);
  NumberPaint specular = 0.0;
  Implicit<NumberPaint> shininess = Implicit<NumberPaint>::unwritten(32.0);
  Highlight highlight = Highlight::blinn;
  Implicit<NumberPaint> metallic = Implicit<NumberPaint>::unwritten(0.0);
  Implicit<Paint> reflect = Implicit<Paint>::unwritten(black);
  NumberPaint refract = 0.0;
  double ior = 1;
  bool fresnel = false;
  std::optional<NumberPaint> roughness = std::nullopt;
  std::optional<Metal> metal = std::nullopt;
  NumberPaint coat = 0.0;
  double coat_roughness = 0;
  double coat_ior = 1.5;
  std::optional<Absorb> absorb = std::nullopt;
  bool thin = false;
  NumberPaint bump = 0.0;
  friend bool operator==(const Material&, const Material&) = default;
};

std::span<const Field> fields(const Material*);

/// Whether it transmits no light anywhere. If a pattern gives the fraction, it may.
inline bool is_opaque(const Material& material) {
  const double* refract = std::get_if<double>(&material.refract);
  return refract && *refract == 0;
}

/// Whether it emits light anywhere. If a pattern gives the amount, it may.
inline bool shines(const Material& material) {
  const Color* emission = std::get_if<Color>(&material.emission);
  return !emission || *emission != black;
}

/// Whether it is the interior of a solid that rays enter and leave.
inline bool is_medium(const Material& material) {
  return !is_opaque(material) && !material.thin;
}

/// A smooth metal's reflectance at normal incidence: ((n − 1)² + k²)/((n + 1)² + k²).
Color normal_reflectance(const Metal& metal);

/// The exponent of a highlight as wide as a surface of this roughness makes it: 2/r⁴ − 2, the Blinn-Phong model's for α
/// = r² (B. Walter et al., Microfacet Models for Refraction through Rough Surfaces, 2007, section 5.2).
double shininess_of(double roughness);

/// With what its `metal` and `roughness` (if not a pattern) imply for properties that were not specified.
Material with_implied(Material material);

} // namespace rt::scene
