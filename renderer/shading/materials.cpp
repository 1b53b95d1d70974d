#include "renderer/shading/materials.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rt {
namespace {

// Calls f with each property that may be a pattern, in the description and evaluated, and what numbers it may be.
template <class F>
void for_each_textured(F&& f) {
  using namespace scene;
  f(&Material::color, &MaterialValues::color, not_negative);
  f(&Material::ambient, &MaterialValues::ambient, not_negative);
  f(&Material::diffuse, &MaterialValues::diffuse, not_negative);
  f(&Material::emission, &MaterialValues::emission, not_negative);
  f(&Material::specular, &MaterialValues::specular, not_negative);
  f(&Material::shininess, &MaterialValues::shininess, positive);
  f(&Material::metallic, &MaterialValues::metallic, zero_to_one);
  f(&Material::reflect, &MaterialValues::reflect, not_negative);
  f(&Material::refract, &MaterialValues::refract, zero_to_one);
  f(&Material::roughness, &MaterialValues::roughness, zero_to_one);
  f(&Material::coat, &MaterialValues::coat, zero_to_one);
  f(&Material::bump, &MaterialValues::bump, not_negative);
}

// The paint of a property, or null if it is not specified.
template <class P>
const P* shown(const P& paint) {
  return &paint;
}
template <class P>
const P* shown(const scene::Implicit<P>& paint) {
  return &paint.value();
}
template <class P>
const P* shown(const std::optional<P>& paint) {
  return paint ? &*paint : nullptr;
}

double least(const scene::Constraint& allowed) {
  return allowed.min_is_excluded ? std::nextafter(allowed.min, allowed.max) : allowed.min;
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
    patterns_.push_back({to_pattern.value_or(Affine{}), pattern.layout});
  }
  entries_.reserve(scene.materials.size() + 1);
  for (std::size_t i = entries_.size() - 1; i < scene.materials.size(); ++i) add(scene.materials[i]);
}

void Materials::add(const scene::Material& described) {
  const scene::Material m = with_implied(described);
  MaterialEntry& entry = entries_.emplace_back();
  entry.first_texture = static_cast<std::uint32_t>(textures_.size());
  entry.values.ior = m.ior;
  entry.values.highlight = m.highlight;
  entry.values.fresnel = m.fresnel;
  entry.values.metal = m.metal;
  entry.values.coat_roughness = m.coat_roughness;
  entry.values.coat_ior = m.coat_ior;
  entry.values.thin = m.thin;
  if (m.absorb && is_medium(m)) entry.absorption = Absorption(*m.absorb);
  absorbs_ = absorbs_ || !entry.absorption.is_clear();
  entry.roughness_implies_shininess = m.roughness && m.roughness->index() == 1 && !m.shininess.is_written();
  for_each_textured([&](auto member, auto property, const scene::Constraint& allowed) {
    const auto* paint = shown(m.*member);
    if (!paint) return;
    if (const scene::PatternId* pattern = std::get_if<scene::PatternId>(paint))
      textures_.push_back({*pattern, property, least(allowed), allowed.max});
    else
      entry.values.*property = std::get<0>(*paint);
  });
  if (const scene::PatternId* bumps = std::get_if<scene::PatternId>(&m.bump)) {
    // Far less than what patterns are made of, one unit of their own, and far more than rounding.
    constexpr double step = 1e-4;
    const Affine& to_pattern = patterns_[static_cast<std::size_t>(*bumps)].to_pattern;
    entry.bumps = {*bumps, step / std::max({length(to_pattern.x), length(to_pattern.y), length(to_pattern.z)})};
  }
  entry.texture_count = static_cast<std::uint32_t>(textures_.size()) - entry.first_texture;
}

MaterialValues Materials::at(std::uint32_t material, const Vec3& p) const {
  const MaterialEntry& entry = entries_[material];
  MaterialValues values = entry.values;
  for (std::uint32_t i = 0; i < entry.texture_count; ++i) {
    const Texture& texture = textures_[entry.first_texture + i];
    const Color shown = color_of(texture.pattern, p);
    const double number_shown = std::clamp(shown.r, texture.least, texture.most);
    if (const auto* color = std::get_if<Color MaterialValues::*>(&texture.property))
      values.** color = shown;
    else if (const auto* number = std::get_if<double MaterialValues::*>(&texture.property))
      values.** number = number_shown;
    else
      values.*std::get<std::optional<double> MaterialValues::*>(texture.property) = number_shown;
  }
  if (entry.roughness_implies_shininess) values.shininess = scene::shininess_of(*values.roughness);
  return values;
}

Vec3 Materials::bump_gradient(std::uint32_t material, const Vec3& p) const {
  const auto& [pattern, step] = *entries_[material].bumps;
  const auto slope = [&, id = pattern, h = step](const Vec3& axis) {
    return (color_of(id, p + axis * h).r - color_of(id, p - axis * h).r) / (2 * h);
  };
  return {slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})};
}

// Every pattern, also one that stands within another, lives in the space of the object that writes the material. A
// pattern refers to patterns that were made before it, so the walk ends.
Color Materials::color_of(const scene::Paint& paint, const Vec3& p) const {
  if (const Color* color = std::get_if<Color>(&paint)) return *color;
  const Pattern& pattern = patterns_[static_cast<std::size_t>(std::get<scene::PatternId>(paint))];
  const Vec3 q = pattern.to_pattern.point(p);
  return std::visit([&](const auto& layout) { return color_of(paint_at(layout, q), p); }, pattern.layout);
}

Color Materials::color_of(const PaintBlend& blend, const Vec3& p) const {
  const Color first = color_of(blend.first, p);
  if (blend.share == 0 || blend.first == blend.second) return first;
  return first * (1 - blend.share) + color_of(blend.second, p) * blend.share;
}

} // namespace rt
