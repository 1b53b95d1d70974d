#pragma once

#include "renderer/shading/bent_normal.hpp"
#include "renderer/shading/materials.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// A material as used by one object: with the placement of its patterns. Index in `MaterialBindings`.
enum class BindingId : std::uint32_t {};

/// That of the composite that contains the object.
inline constexpr BindingId inherited_binding{0x7fffffff};

/// All bindings of a compiled scene, over its materials.
class MaterialBindings {
public:
  explicit MaterialBindings(const scene::Scene& scene);

  /// Adds the materials added to the scene since. Ids handed out earlier stay valid.
  void extend(const scene::Scene& scene);

  /// How many pattern placements there are; `release` drops the later ones, with their bindings.
  struct Mark {
    std::size_t bindings, places;
  };
  Mark mark() const { return {bindings_.size(), places_.size()}; }
  void release(const Mark& mark);

  const Materials& materials() const { return materials_; }

  static BindingId default_binding() { return BindingId{0}; }

  /// The binding of an object that is placed by `to_outer` in the space where the binding is evaluated, and inherits
  /// `inherited` if it has no material.
  BindingId of(const scene::Object& object, const Affine& to_outer, BindingId inherited);

  /// Whether it transmits no light anywhere.
  bool is_opaque(BindingId binding) const { return at(binding).is_opaque; }
  /// Whether rays that pass through it enter or leave a medium.
  bool is_medium(BindingId binding) const { return at(binding).is_medium; }
  /// Whether the index of refraction of the binding's material matters, and whether any binding's does.
  bool uses_ior(BindingId binding) const { return at(binding).uses_ior; }
  bool uses_ior() const { return uses_ior_; }
  /// Whether it emits light somewhere, and whether any binding does.
  bool shines(BindingId binding) const { return at(binding).shines; }
  bool any_shines() const { return any_shines_; }
  std::uint32_t material(BindingId binding) const { return at(binding).material; }
  /// 1 where it does not matter.
  double ior(BindingId binding) const { return uses_ior(binding) ? materials_.constant(at(binding).material).ior : 1; }

  /// The absorption inside a material, by its index; and whether any material absorbs.
  const Absorption& absorption(std::uint32_t material) const { return materials_.absorption(material); }
  bool absorbs() const { return materials_.absorbs(); }

  /// Where patterns are evaluated for the point `p` of the space where the binding is evaluated.
  [[gnu::always_inline]] Vec3 pattern_point(BindingId binding, const Vec3& p) const {
    const std::uint32_t place = at(binding).place;
    return place == nowhere ? p : point_at(place, p);
  }
  /// The values at such a point. `scratch` holds them if they are not constant.
  const MaterialValues& values(std::uint32_t material, const Vec3& pattern_point, MaterialValues& scratch) const {
    if (!materials_.has_patterns(material)) return materials_.constant(material);
    return scratch = materials_.at(material, pattern_point);
  }
  /// Whether its material has bumps.
  bool is_bumpy(BindingId binding) const { return at(binding).is_bumpy; }
  /// How they bend the unit normal at a point whose `pattern_point` is given.
  BentNormal bent_normal(BindingId binding, const Vec3& pattern_point, const Vec3& normal) const;
  /// The transmittance of the surface at a point.
  Color transmittance(BindingId binding, const Vec3& p) const {
    const std::uint32_t material = at(binding).material;
    const MaterialValues& constant = materials_.constant(material);
    if (!materials_.has_patterns(material)) return constant.color * constant.refract;
    const MaterialValues v = materials_.at(material, pattern_point(binding, p));
    return v.color * v.refract;
  }

private:
  static constexpr std::uint32_t nowhere = 0xffffffff;
  struct MaterialBinding {
    std::uint32_t material;
    std::uint32_t place;
    bool is_opaque;
    bool is_medium;
    bool uses_ior;
    bool shines;
    bool is_bumpy;
  };
  const MaterialBinding& at(BindingId id) const { return bindings_[static_cast<std::size_t>(id)]; }
  [[gnu::noinline]] Vec3 point_at(std::uint32_t place, const Vec3& p) const { return places_[place].point(p); }

  Materials materials_;
  std::vector<MaterialBinding> bindings_; // the first is the default material's
  std::vector<BindingId> placeless_;      // by the scene's material index
  std::vector<Affine> places_;
  bool uses_ior_ = false;
  bool any_shines_ = false;
};

} // namespace rt
