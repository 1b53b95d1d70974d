#include "renderer/styles.hpp"

#include <cassert>

namespace rt {

Styles::Styles(const scene::Scene& scene) : materials_(scene) {
  for (std::uint32_t i = 0; i <= materials_.default_material(); ++i) {
    const bool is_opaque = materials_.constant(i).refract == 0;
    styles_.push_back({i, nowhere, is_opaque});
    has_transparent_ = has_transparent_ || !is_opaque;
  }
}

// The patterns of a material live in the space of the object that writes it, before its own transform.
StyleId Styles::of(const scene::Object& object, const Affine& to_outer, StyleId inherited) {
  if (object.material == scene::no_material) return inherited;
  const auto material = static_cast<std::uint32_t>(object.material);
  if (!materials_.has_patterns(material)) return StyleId{material};
  const std::optional<Affine> to_object = inverse(to_outer);
  assert(to_object && "a transform must not flatten its object");
  styles_.push_back({material, static_cast<std::uint32_t>(places_.size()), styles_[material].is_opaque});
  places_.push_back(to_object.value_or(Affine{}));
  return StyleId{static_cast<std::uint32_t>(styles_.size() - 1)};
}

} // namespace rt
