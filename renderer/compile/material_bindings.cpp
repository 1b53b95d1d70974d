#include "renderer/compile/material_bindings.hpp"

#include <cassert>

namespace rt {

MaterialBindings::MaterialBindings(const scene::Scene& scene) : materials_(scene) {
  bindings_.push_back({materials_.default_material(), nowhere, true, false, false, false, false});
  extend(scene);
}

void MaterialBindings::extend(const scene::Scene& scene) {
  materials_.extend(scene);
  for (std::size_t i = placeless_.size(); i < scene.materials.size(); ++i) {
    const std::uint32_t material = Materials::index(scene::MaterialId{static_cast<std::uint32_t>(i)});
    const bool is_opaque = scene::is_opaque(scene.materials[i]), uses_ior = !is_opaque || scene.materials[i].fresnel;
    placeless_.push_back(BindingId{static_cast<std::uint32_t>(bindings_.size())});
    const bool shines = scene::shines(scene.materials[i]);
    bindings_.push_back({material, nowhere, is_opaque, scene::is_medium(scene.materials[i]), uses_ior, shines,
                         materials_.is_bumpy(material)});
    uses_ior_ = uses_ior_ || uses_ior;
    any_shines_ = any_shines_ || shines;
  }
}

BentNormal MaterialBindings::bent_normal(BindingId binding, const Vec3& pattern_point, const Vec3& normal) const {
  const MaterialBinding& b = at(binding);
  const Affine to_object = b.place == nowhere ? Affine{} : places_[b.place];
  const Vec3 gradient = materials_.bump_gradient(b.material, pattern_point), own = normalize(to_object.normal(normal));
  BentNormal bent{own, gradient - own * dot(gradient, own)};
  bent.carry(to_object);
  return bent;
}

void MaterialBindings::release(const Mark& mark) {
  bindings_.erase(bindings_.begin() + static_cast<std::ptrdiff_t>(mark.bindings), bindings_.end());
  places_.erase(places_.begin() + static_cast<std::ptrdiff_t>(mark.places), places_.end());
}

// The patterns of a material are in the space of the object that specifies it, before its own transform.
BindingId MaterialBindings::of(const scene::Object& object, const Affine& to_outer, BindingId inherited) {
  if (object.material == scene::no_material) return inherited;
  const BindingId placeless = placeless_[static_cast<std::size_t>(object.material)];
  const std::uint32_t material = at(placeless).material;
  if (!materials_.has_patterns(material)) return placeless;
  const std::optional<Affine> to_object = inverse(to_outer);
  assert(to_object && "a transform must not flatten its object");
  bindings_.push_back(at(placeless));
  bindings_.back().place = static_cast<std::uint32_t>(places_.size());
  places_.push_back(to_object.value_or(Affine{}));
  return BindingId{static_cast<std::uint32_t>(bindings_.size() - 1)};
}

} // namespace rt
