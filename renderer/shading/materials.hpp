#pragma once

#include "renderer/math/affine.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/shading/absorption.hpp"

#include <variant>
#include <vector>

namespace rt {

/// A material at one point: its patterns evaluated.
struct MaterialValues {
  Color color = white;
  Color ambient = grey(1), diffuse = grey(0.8), emission = grey(0);
  Color reflect = black;
  double specular = 0;
  double shininess = 32;
  double metallic = 0;
  double refract = 0;
  double ior = 1;
  scene::Highlight highlight = scene::Highlight::blinn;
  bool fresnel = false;
  std::optional<double> roughness = std::nullopt;
  std::optional<scene::Metal> metal = std::nullopt;
  double coat = 0, coat_roughness = 0, coat_ior = 1.5;
  bool thin = false;
  double bump = 0; ///< the height, which itself shows nowhere
  friend bool operator==(const MaterialValues&, const MaterialValues&) = default;
};

/// The materials and patterns of a scene, ready to be evaluated.
class Materials {
public:
  Materials() = default;
  explicit Materials(const scene::Scene& scene);

  /// Adds the materials and patterns added to the scene since: the earlier ones must still be there, unchanged.
  void extend(const scene::Scene& scene);

  /// The index of the default material, a matte white, and of the scene's own.
  static constexpr std::uint32_t default_material() { return 0; }
  static std::uint32_t index(scene::MaterialId material) { return static_cast<std::uint32_t>(material) + 1; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(entries_.size()); }

  /// The absorption of the material's interior; none for most.
  const Absorption& absorption(std::uint32_t material) const { return entries_[material].absorption; }
  /// Whether any of them absorbs.
  bool absorbs() const { return absorbs_; }

  bool has_patterns(std::uint32_t material) const { return entries_[material].texture_count > 0; }

  /// Whether a pattern gives that property.
  template <class T>
  bool varies(std::uint32_t material, T MaterialValues::*property) const {
    const MaterialEntry& entry = entries_[material];
    for (std::uint32_t i = entry.first_texture; i < entry.first_texture + entry.texture_count; ++i)
      if (const auto* found = std::get_if<T MaterialValues::*>(&textures_[i].property); found && *found == property)
        return true;
    return false;
  }

  /// The values of a material without patterns; for one with patterns only those are right that no pattern gives.
  const MaterialValues& constant(std::uint32_t material) const { return entries_[material].values; }

  /// Whether it has bumps.
  bool is_bumpy(std::uint32_t material) const { return entries_[material].bumps.has_value(); }
  /// The gradient of the heights of a bumpy material at `p`, given in the space that its patterns live in.
  Vec3 bump_gradient(std::uint32_t material, const Vec3& p) const;

  /// The values at `p`, in the space of the material's patterns.
  MaterialValues at(std::uint32_t material, const Vec3& p) const;

private:
  struct Bumps {
    scene::PatternId pattern;
    double step; // over which their slope is taken
  };
  struct MaterialEntry {
    MaterialValues values;
    Absorption absorption{};
    std::uint32_t first_texture = 0, texture_count = 0;
    bool roughness_implies_shininess = false; ///< a pattern gives the former
    std::optional<Bumps> bumps = std::nullopt;
  };
  // A property that a pattern gives. A function may give numbers beyond what the property takes: they are held.
  struct Texture {
    scene::PatternId pattern;
    std::variant<Color MaterialValues::*, double MaterialValues::*, std::optional<double> MaterialValues::*> property;
    double least, most; // where it is a number
  };
  struct Pattern {
    Affine to_pattern; // from the space it is placed in
    scene::PatternLayout layout;
  };
  void add(const scene::Material& material);
  Color color_of(const scene::Paint& paint, const Vec3& p) const;
  Color color_of(const PaintBlend& blend, const Vec3& p) const;

  std::vector<MaterialEntry> entries_;
  std::vector<Texture> textures_; // by material
  std::vector<Pattern> patterns_;
  bool absorbs_ = false;
};

} // namespace rt
