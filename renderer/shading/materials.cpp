#include "renderer/shading/materials.hpp"

#include <cassert>
#include <cmath>

namespace rt {
namespace {

bool is_pattern(const scene::Paint& paint) {
  return std::holds_alternative<scene::PatternId>(paint);
}

Color constant_part(const scene::Paint& paint) {
  const Color* color = std::get_if<Color>(&paint);
  return color ? *color : black;
}

// Unit cells; the small shift before rounding keeps a floor at a whole number stable, and is POV-Ray's own.
bool is_first_of_checker(const Vec3& p) {
  const double cells = std::floor(p.x + 1e-10) + std::floor(p.y + 1e-10) + std::floor(p.z + 1e-10);
  return std::fmod(cells, 2) == 0;
}

} // namespace

Materials::Materials(const scene::Scene& scene) {
  add({});
  extend(scene);
}

void Materials::extend(const scene::Scene& scene) {
  patterns_.reserve(scene.patterns.size());
  for (std::size_t i = patterns_.size(); i < scene.patterns.size(); ++i) {
    const scene::Pattern& pattern = scene.patterns[i];
    const auto to_pattern = inverse(matrix(pattern.placement));
    assert(to_pattern && "a pattern's placement must not flatten it");
    patterns_.push_back({to_pattern.value_or(Affine{}), pattern.a, pattern.b});
  }
  entries_.reserve(scene.materials.size() + 1);
  for (std::size_t i = entries_.size() - 1; i < scene.materials.size(); ++i) add(scene.materials[i]);
}

void Materials::add(const scene::Material& m) {
  entries_.push_back(
      {{constant_part(m.color), constant_part(m.ambient), constant_part(m.diffuse), constant_part(m.emission),
        m.reflect, m.specular, m.shininess, m.metallic, m.refract, m.ior, m.highlight, m.fresnel},
       m.color,
       m.ambient,
       m.diffuse,
       m.emission,
       is_pattern(m.color) || is_pattern(m.ambient) || is_pattern(m.diffuse) || is_pattern(m.emission)});
}

MaterialValues Materials::at(std::uint32_t material, const Vec3& p) const {
  const MaterialEntry& entry = entries_[material];
  MaterialValues values = entry.values;
  values.color = evaluate(entry.color, p);
  values.ambient = evaluate(entry.ambient, p);
  values.diffuse = evaluate(entry.diffuse, p);
  values.emission = evaluate(entry.emission, p);
  return values;
}

// Every pattern, also one that stands within another, lives in the space of the object that writes the material. A
// pattern refers to patterns that were made before it, so the walk ends.
Color Materials::evaluate(const scene::Paint& paint, const Vec3& p) const {
  const scene::Paint* at = &paint;
  while (const scene::PatternId* id = std::get_if<scene::PatternId>(at)) {
    const Pattern& pattern = patterns_[static_cast<std::size_t>(*id)];
    at = is_first_of_checker(pattern.to_pattern.point(p)) ? &pattern.a : &pattern.b;
  }
  return std::get<Color>(*at);
}

} // namespace rt
