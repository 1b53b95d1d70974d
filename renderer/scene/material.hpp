#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/scene/transform.hpp"

namespace rt::scene {

/// Index of a material in `Scene::materials`; `no_material` inherits the enclosing composite's, in the end the default.
enum class MaterialId : std::uint32_t {};
inline constexpr MaterialId no_material{0xffffffff};

enum class Highlight : std::uint8_t { blinn, phong };

/// The surface and, through `ior`, the inside of a solid: Whitted's model (An Improved Illumination Model for Shaded
/// Display, 1980) with ambient, emission, metallic tint and Fresnel. The default material is a white matte.
struct Material {
  Paint color = white;
  Paint ambient = grey(1);
  Paint diffuse = grey(0.8);
  Paint emission = grey(0);
  double specular = 0;
  double shininess = 32;
  Highlight highlight = Highlight::blinn;
  double metallic = 0;
  Color reflect = black;
  double refract = 0;
  double ior = 1;
  bool fresnel = false;
  friend bool operator==(const Material&, const Material&) = default;
};

std::span<const Field> material_fields();

enum class PatternKind : std::uint8_t { checker };

/// Two paints laid out over space. It lives in the space of the object that writes `material:`, before that object's
/// own transform; `placement` moves it there.
struct Pattern {
  PatternKind kind = PatternKind::checker;
  Paint a = white;
  Paint b = black;
  Placement placement;
};

/// The fields of every pattern, without the placement's (scale, rotate, at).
std::span<const Field> pattern_fields();

} // namespace rt::scene
