#pragma once

#include "renderer/compile/leaves/leaves.hpp"
#include "renderer/compile/leaves/sphere_pack.hpp"

#include <bit>
#include <vector>

namespace rt {

/// Spheres are stored eight to a leaf, each with its neighbours: the tree is an eighth the size, which means fewer
/// cache misses, and one call instead of eight. A hit is still with a single sphere; `tag` and `surface` refer to it.
template <>
class ShapeLeaves<Baked<SphereGeometry>> {
public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(packs_.size()); }
  Box3 bounds(std::uint32_t i) const;
  LeafTag tag(std::uint32_t sphere) const { return tags_[sphere]; }
  std::uint32_t shape_count() const { return static_cast<std::uint32_t>(tags_.size()); }
  Baked<SphereGeometry> shape(std::uint32_t sphere) const {
    return {packs_[sphere / SpherePack::size].sphere(sphere % SpherePack::size)};
  }
  void reserve(std::size_t count) { added_.reserve(count); }
  void add(const Baked<SphereGeometry>& placed, LeafTag tag) { added_.push_back({placed.shape, tag}); }
  /// Makes leaves of the spheres that were added.
  void arrange();

  [[gnu::always_inline]] void nearest(std::uint32_t i, NearestQuery& query) const {
    const SpherePackChords chords(packs_[i], query.ray, query.inverse_square);
    for (unsigned rest = chords.meets(); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
      Hit near, far, hit;
      chords[lane].roots(near.t, far.t);
      if (!take_first(near, far, query.interval, hit)) continue;
      const std::uint32_t sphere = i * SpherePack::size + lane;
      query.offer(hit, tags_[sphere].slot, sphere, leaf_kind<ShapeLeaves>, this);
    }
  }

  [[gnu::always_inline]] bool blocks(std::uint32_t i, ShadowQuery& query) const {
    if (query.inspects) [[unlikely]]
      return inspect(i, static_cast<InspectQuery&>(query));
    const SpherePackChords chords(packs_[i], query.ray, query.inverse_square);
    for (unsigned rest = chords.meets(); rest != 0; rest &= rest - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(rest));
      const LeafTag tag = tags_[i * SpherePack::size + lane];
      if (!tag.casts_shadow) continue;
      double near = 0, far = 0;
      chords[lane].roots(near, far);
      const bool has_near = query.interval.contains(near), has_far = far > near && query.interval.contains(far);
      if (!has_near && !has_far) continue;
      if (query.bindings.is_opaque(query.resolved(tag.binding_id()))) return true;
      if (has_near) query.add_attenuation(near, tag.slot, 0, query.transmittance(tag.binding_id(), near));
      if (has_far) query.add_attenuation(far, tag.slot, has_near, query.transmittance(tag.binding_id(), far));
    }
    return false;
  }

  LeafSurface surface(const MaterialBindings& bindings, const Ray& ray, const RayHit& hit) const {
    const SphereGeometry sphere = packs_[hit.index / SpherePack::size].sphere(hit.index % SpherePack::size);
    const BindingId binding = tags_[hit.index].binding_id();
    LeafSurface s{surface_point(sphere, ray, hit), binding, binding};
    if (binding != inherited_binding) s.bind(binding, bindings);
    return s;
  }

private:
  struct Added {
    SphereGeometry sphere;
    LeafTag tag;
  };

  bool inspect(std::uint32_t i, InspectQuery& query) const;

  std::vector<Added> added_; // until arranged
  std::vector<SpherePack> packs_;
  std::vector<LeafTag> tags_; // by sphere; only the last pack can have fewer than eight
};

} // namespace rt
