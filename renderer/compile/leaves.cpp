#include "renderer/compile/leaves.hpp"

#include "renderer/compile/aggregate.hpp"

#include <cassert>

namespace rt {
namespace {

// The ray in the space of a leaf that was made elsewhere.
template <class Leaf>
Ray carried(const Leaf& leaf, const Ray& ray) {
  return leaf.to_local.ray(ray);
}

// The boundaries of a solid along a ray, for as long as this exists.
class Boundaries {
public:
  Boundaries(const CsgSolid& solid, const Ray& ray, TraceScratch& scratch)
      : list_(scratch.boundaries), begin_(list_.size()) {
    solid.push_boundaries(ray, scratch);
  }
  ~Boundaries() { list_.resize(begin_); }
  Boundaries(const Boundaries&) = delete;
  Boundaries& operator=(const Boundaries&) = delete;

  auto begin() const { return list_.cbegin() + static_cast<std::ptrdiff_t>(begin_); }
  auto end() const { return list_.cend(); }

private:
  std::vector<Boundary>& list_;
  std::size_t begin_;
};

} // namespace

void SolidLeaves::nearest(std::uint32_t i, NearestQuery& query) const {
  const Leaf& leaf = leaves_[i];
  const Ray ray = leaf.is_in_place ? query.ray : carried(leaf, query.ray);
  for (const Boundary& b : Boundaries(*leaf.solid, ray, query.scratch)) {
    if (!query.interval.contains(b.t)) continue;
    if (query.offer({b.t, b.shape_part}, tags_[i].slot, i, leaf_kind<SolidLeaves>, this)) {
      query.best.operand = b.operand;
      query.best.is_flipped = b.is_flipped;
    }
    return;
  }
}

bool SolidLeaves::blocks(std::uint32_t i, ShadowQuery& query) const {
  if (query.inspects) return inspect(i, static_cast<InspectQuery&>(query));
  const LeafTag tag = tags_[i];
  if (!tag.casts_shadow) return false;
  const Leaf& leaf = leaves_[i];
  const Ray ray = leaf.is_in_place ? query.ray : carried(leaf, query.ray);
  std::uint32_t sequence = 0;
  for (const Boundary& b : Boundaries(*leaf.solid, ray, query.scratch)) {
    if (!query.interval.contains(b.t)) continue;
    const CsgSolid::Operand& operand = leaf.solid->operand(b.operand);
    if (!operand.casts_shadow) continue;
    const bool inherits = operand.binding == inherited_binding;
    const BindingId binding = inherits ? query.resolved(tag.style_id()) : operand.binding;
    if (query.bindings.is_opaque(binding)) return true;
    query.add_attenuation(b.t, tag.slot, sequence++,
                          inherits ? query.transmittance(tag.style_id(), b.t)
                                   : query.bindings.transmittance(binding, ray.at(b.t)));
  }
  return false;
}

bool SolidLeaves::inspect(std::uint32_t i, InspectQuery& query) const {
  const Leaf& leaf = leaves_[i];
  const Ray ray = leaf.is_in_place ? query.ray : carried(leaf, query.ray);
  if (query.hits) {
    for (const Boundary& b : Boundaries(*leaf.solid, ray, query.scratch))
      if (query.interval.contains(b.t)) query.add_hit(b, i, leaf_kind<SolidLeaves>, this);
  }
  const BindingId inherited = query.resolved(tags_[i].style_id());
  if (query.around && leaf.solid->is_medium(query.bindings, inherited) && leaf.solid->contains(ray.origin))
    query.add_around(tags_[i].slot, ior(i, query.bindings, inherited));
  return false;
}

double SolidLeaves::ior(std::uint32_t i, const MaterialBindings& bindings, BindingId inherited) const {
  if (leaves_[i].owns_style && bindings.uses_ior(inherited)) return bindings.ior(inherited);
  return leaves_[i].solid->ior(bindings, inherited);
}

LeafSurface SolidLeaves::surface(const MaterialBindings& bindings, const Ray& outer, const RayHit& hit) const {
  const Leaf& leaf = leaves_[hit.index];
  const Ray ray = leaf.is_in_place ? outer : carried(leaf, outer);
  const BindingId own = tags_[hit.index].style_id();
  LeafSurface s{leaf.solid->point(ray, hit), leaf.solid->operand(hit.operand).binding, own};
  if (s.binding != inherited_binding) s.pattern_point = bindings.pattern_point(s.binding, s.point.position);
  if (!leaf.is_in_place) s.point = mapped(s.point, leaf.to_outer, leaf.to_local);
  if (s.binding == inherited_binding && own != inherited_binding) {
    s.binding = own;
    s.pattern_point = bindings.pattern_point(own, s.point.position);
  }
  s.solids = this;
  return s;
}

Box3 InstanceLeaves::bounds(std::uint32_t i) const {
  if (leaves_[i].part_begin) return leaves_[i].aggregate->box();
  return transform_box(leaves_[i].to_outer, leaves_[i].aggregate->box());
}

void InstanceLeaves::nearest(std::uint32_t i, NearestQuery& query) const {
  const Leaf& leaf = leaves_[i];
  NearestQuery inner(leaf.part_begin ? query.ray : carried(leaf, query.ray), query.interval, *leaf.aggregate,
                     query.base + leaf.order, query.best, query.scratch);
  leaf.aggregate->nearest(inner);
  query.interval.upper = inner.interval.upper;
}

bool InstanceLeaves::blocks(std::uint32_t i, ShadowQuery& query) const {
  const LeafTag tag = tags_[i];
  if (!tag.casts_shadow && !query.inspects) return false;
  const Leaf& leaf = leaves_[i];
  const Ray ray = leaf.part_begin ? query.ray : carried(leaf, query.ray);
  const std::uint64_t base = query.base + leaf.order;
  const InheritedBinding inherited =
      tag.style_id() == inherited_binding ? query.inherited : InheritedBinding{tag.style_id(), &query.ray};
  if (query.inspects) {
    const auto& outer = static_cast<const InspectQuery&>(query);
    InspectQuery inner(ray, query.interval, *leaf.aggregate, base, query.bindings, inherited, query.scratch);
    inner.inspects = true;
    inner.hits = outer.hits;
    inner.around = outer.around;
    return leaf.aggregate->blocks(inner);
  }
  ShadowQuery inner(ray, query.interval, *leaf.aggregate, base, query.bindings, inherited, query.scratch);
  return leaf.aggregate->blocks(inner);
}

LeafSurface InstanceLeaves::surface(const MaterialBindings&, const Ray&, const RayHit&) const {
  assert(false && "a hit is on a leaf of the instance's assembly");
  return {};
}

} // namespace rt
