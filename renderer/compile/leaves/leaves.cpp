#include "renderer/compile/leaves/leaves.hpp"

#include "renderer/compile/aggregate.hpp"

#include <cassert>

namespace rt {
namespace {

// The boundaries of a solid along a ray, for the lifetime of this object.
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
  const PlacedSolid& placed = solids_[i];
  const Ray ray = placed.is_in_place ? query.ray : placed.to_local.ray(query.ray);
  const Boundaries boundaries(*placed.solid, ray, query.scratch);
  for (auto b = boundaries.begin(); b != boundaries.end(); ++b) {
    if (!query.interval.contains(b->t)) continue;
    if (query.offer(*b, tags_[i].slot, i, leaf_kind<SolidLeaves>, this)) {
      query.best.operand = b->operand;
      query.best.is_flipped = b->is_flipped;
      // A seam between parts that touch.
      if (b + 1 != boundaries.end() && (b + 1)->t <= query.slack.end(b->t)) query.best.is_contested = true;
    }
    return;
  }
}

bool SolidLeaves::blocks(std::uint32_t i, ShadowQuery& query) const {
  if (query.inspects) return inspect(i, static_cast<InspectQuery&>(query));
  const LeafTag tag = tags_[i];
  if (!tag.casts_shadow) return false;
  const PlacedSolid& placed = solids_[i];
  const Ray ray = placed.is_in_place ? query.ray : placed.to_local.ray(query.ray);
  std::uint32_t sequence = 0;
  for (const Boundary& b : Boundaries(*placed.solid, ray, query.scratch)) {
    if (!query.interval.contains(b.t)) continue;
    const CsgSolid::Operand& operand = placed.solid->operand(b.operand);
    if (!operand.casts_shadow) continue;
    const bool inherits = operand.binding == inherited_binding;
    const BindingId binding = inherits ? query.resolved(tag.binding_id()) : operand.binding;
    if (query.bindings.is_opaque(binding)) return true;
    query.add_attenuation(b.t, tag.slot, sequence++,
                          inherits ? query.transmittance(tag.binding_id(), b.t)
                                   : query.bindings.transmittance(binding, ray.at(b.t)));
  }
  return false;
}

bool SolidLeaves::inspect(std::uint32_t i, InspectQuery& query) const {
  const PlacedSolid& placed = solids_[i];
  const Ray ray = placed.is_in_place ? query.ray : placed.to_local.ray(query.ray);
  if (query.hits) {
    for (const Boundary& b : Boundaries(*placed.solid, ray, query.scratch))
      if (query.interval.contains(b.t)) query.add_hit(b, i, leaf_kind<SolidLeaves>, this);
  }
  const BindingId inherited = query.resolved(tags_[i].binding_id());
  if (query.around && placed.solid->is_medium(query.bindings, inherited) && placed.solid->contains(ray.origin))
    query.add_around(tags_[i].slot, medium(i, query.bindings, inherited));
  return false;
}

BindingId SolidLeaves::medium(std::uint32_t i, const MaterialBindings& bindings, BindingId inherited) const {
  if (solids_[i].owns_material && bindings.uses_ior(inherited)) return inherited;
  return solids_[i].solid->medium(bindings, inherited);
}

LeafSurface SolidLeaves::surface(const MaterialBindings& bindings, const Ray& outer, const RayHit& hit) const {
  const PlacedSolid& placed = solids_[hit.index];
  const Ray ray = placed.is_in_place ? outer : placed.to_local.ray(outer);
  const BindingId own = tags_[hit.index].binding_id();
  LeafSurface s{placed.solid->point(ray, hit), placed.solid->operand(hit.operand).binding, own};
  if (s.binding != inherited_binding) s.bind(s.binding, bindings);
  if (!placed.is_in_place) {
    s.point = mapped(s.point, placed.to_outer, placed.to_local);
    if (s.bent_normal) s.bent_normal->carry(placed.to_local);
  }
  if (s.binding == inherited_binding && own != inherited_binding) s.bind(own, bindings);
  s.solids = this;
  return s;
}

Box3 InstanceLeaves::bounds(std::uint32_t i) const {
  if (instances_[i].part_begin) return instances_[i].aggregate->box();
  return transform_box(instances_[i].to_outer, instances_[i].aggregate->box());
}

void InstanceLeaves::nearest(std::uint32_t i, NearestQuery& query) const {
  const Instance& instance = instances_[i];
  NearestQuery inner(instance.part_begin ? query.ray : instance.to_local.ray(query.ray), query.interval, query.slack,
                     *instance.aggregate, query.base + instance.order, query.best, query.scratch);
  instance.aggregate->nearest(inner);
  query.interval.upper = inner.interval.upper;
}

bool InstanceLeaves::blocks(std::uint32_t i, ShadowQuery& query) const {
  const LeafTag tag = tags_[i];
  if (!tag.casts_shadow && !query.inspects) return false;
  const Instance& instance = instances_[i];
  const Ray ray = instance.part_begin ? query.ray : instance.to_local.ray(query.ray);
  const std::uint64_t base = query.base + instance.order;
  const InheritedBinding inherited =
      tag.binding_id() == inherited_binding ? query.inherited : InheritedBinding{tag.binding_id(), &query.ray};
  if (query.inspects) {
    const auto& outer = static_cast<const InspectQuery&>(query);
    InspectQuery inner(ray, query.interval, *instance.aggregate, base, query.bindings, inherited, query.scratch);
    inner.inspects = true;
    inner.hits = outer.hits;
    inner.around = outer.around;
    return instance.aggregate->blocks(inner);
  }
  ShadowQuery inner(ray, query.interval, *instance.aggregate, base, query.bindings, inherited, query.scratch);
  return instance.aggregate->blocks(inner);
}

LeafSurface InstanceLeaves::surface(const MaterialBindings&, const Ray&, const RayHit&) const {
  assert(false && "a hit is on a leaf of the instance's aggregate");
  return {};
}

} // namespace rt
