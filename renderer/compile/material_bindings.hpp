#pragma once

#include "renderer/shading/materials.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// A material as one object writes it: with the place of its patterns. Index in `Styles`.
enum class StyleId : std::uint32_t {};

/// The style of the composite that the object stands in.
inline constexpr StyleId inherited_style{0x7fffffff};

/// All styles of a compiled scene, over its materials.
class Styles {
public:
  explicit Styles(const scene::Scene& scene);

  /// Adds the materials that the scene has got since. What was given out stays as it is.
  void extend(const scene::Scene& scene);

  /// How many places of patterns there are; `release` forgets those that came later, with their styles.
  struct Mark {
    std::size_t styles, places;
  };
  Mark mark() const { return {styles_.size(), places_.size()}; }
  void release(const Mark& mark);

  static StyleId default_style() { return StyleId{0}; }

  /// The style of an object that stands by `to_outer` in the space that the style is asked about in, and would inherit
  /// `inherited` if it wrote no material.
  StyleId of(const scene::Object& object, const Affine& to_outer, StyleId inherited);

  bool is_opaque(StyleId style) const { return at(style).is_opaque; }
  /// Whether the index of refraction of the style's material matters at all, and whether any style's does.
  bool uses_ior(StyleId style) const { return at(style).uses_ior; }
  bool uses_ior() const { return uses_ior_; }
  std::uint32_t material(StyleId style) const { return at(style).material; }
  /// 1 where it does not matter.
  double ior(StyleId style) const { return uses_ior(style) ? materials_.constant(at(style).material).ior : 1; }

  /// Where the patterns see the point `p` of the space that the style is asked about in.
  Vec3 pattern_point(StyleId style, const Vec3& p) const {
    const Style& s = at(style);
    return s.place == nowhere ? p : places_[s.place].point(p);
  }
  /// The values at a point of that kind. `scratch` holds them where they are not constant.
  const MaterialValues& values(std::uint32_t material, const Vec3& pattern_point, MaterialValues& scratch) const {
    if (!materials_.has_patterns(material)) return materials_.constant(material);
    return scratch = materials_.at(material, pattern_point);
  }
  /// What a surface lets by of the light that crosses it.
  Color transmittance(StyleId style, const Vec3& p) const {
    MaterialValues scratch;
    const MaterialValues& v = values(at(style).material, pattern_point(style, p), scratch);
    return v.color * v.refract;
  }

private:
  static constexpr std::uint32_t nowhere = 0xffffffff;
  struct Style {
    std::uint32_t material;
    std::uint32_t place;
    bool is_opaque;
    bool uses_ior;
  };
  const Style& at(StyleId id) const { return styles_[static_cast<std::size_t>(id)]; }

  Materials materials_;
  std::vector<Style> styles_;      // first that of the default material
  std::vector<StyleId> placeless_; // by material as the scene numbers them
  std::vector<Affine> places_;
  bool uses_ior_ = false;
};

} // namespace rt
