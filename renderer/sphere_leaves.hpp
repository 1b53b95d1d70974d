#pragma once

#include "renderer/leaves.hpp"
#include "renderer/shapes/sphere_pack.hpp"

#include <bit>
#include <vector>

namespace rt {

/// Spheres stand four to a leaf, each with its neighbours: a tree a quarter as large, which waits less for memory, and
/// one call of a leaf instead of four. What is hit is still one sphere, and `tag` and `surface` are about that.
template <>
class ShapeLeaves<InPlace<SphereGeometry>> {
public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(packs_.size()); }
  Box3 bounds(std::uint32_t i) const;
  LeafTag tag(std::uint32_t sphere) const { return tags_[sphere]; }
  void reserve(std::size_t count) { added_.reserve(count); }
  void add(const InPlace<SphereGeometry>& placed, LeafTag tag) { added_.push_back({placed.shape, tag}); }
  /// Makes leaves of what was added.
  void arrange();

  void nearest(std::uint32_t i, NearestQuery& query) const {
    std::array<double, SpherePack::size> t;
    for (unsigned hits = intersect(packs_[i], query.ray, query.interval, t); hits != 0; hits &= hits - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(hits));
      if (t[lane] > query.interval.upper) continue; // another of the four is nearer
      const std::uint32_t sphere = i * SpherePack::size + lane;
      query.offer({t[lane], 0}, tags_[sphere].slot, sphere, leaf_kind<ShapeLeaves>, this);
    }
  }

  bool blocks(std::uint32_t i, ShadowQuery& query) const {
    if (query.inspects) [[unlikely]]
      return inspect(i, static_cast<InspectQuery&>(query));
    std::array<double, SpherePack::size> t;
    for (unsigned hits = intersect(packs_[i], query.ray, query.interval, t); hits != 0; hits &= hits - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(hits));
      const LeafTag tag = tags_[i * SpherePack::size + lane];
      if (!tag.casts_shadow) continue;
      if (query.styles.is_opaque(query.resolved(tag.style_id()))) return true;
      filter(packs_[i].sphere(lane), tag, query);
    }
    return false;
  }

  void surface(const Styles& styles, const Ray& ray, const RayHit& hit, LeafSurface& s) const {
    const SphereGeometry sphere = packs_[hit.index / SpherePack::size].sphere(hit.index % SpherePack::size);
    const StyleId style = tags_[hit.index].style_id();
    s.point = surface_point(sphere, ray, {hit.t, hit.shape_part});
    s.style = s.leaf_style = style;
    if (style != inherited_style) s.pattern_point = styles.pattern_point(style, s.point.position);
  }

private:
  struct Added {
    SphereGeometry sphere;
    LeafTag tag;
  };

  static void filter(const SphereGeometry& sphere, LeafTag tag, ShadowQuery& query);
  bool inspect(std::uint32_t i, InspectQuery& query) const;

  std::vector<Added> added_; // until arranged
  std::vector<SpherePack> packs_;
  std::vector<LeafTag> tags_; // by sphere; only the last pack can have fewer than four
};

} // namespace rt
