#include "renderer/compile/aggregate.hpp"

#include "renderer/math/rounding.hpp"

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace rt {
namespace {

// Fewer shapes are faster to test one by one than through a tree. Anything more complex than a shape is worth its box
// test and the front-to-back order: without it nested groups would cost as much as all their copies.
constexpr std::size_t least_for_tree = 4;

// Between equally near leaves of one object. All its sets of leaves are in a single aggregate, so the order of their
// addresses is always the same.
bool is_before(const void* leaves, std::uint32_t index, const RayHit& other) {
  if (leaves != other.leaves) return std::less<>()(leaves, other.leaves);
  return index < other.index;
}

// Of what stands in the instance, if that is not finite as a whole.
double reach_of(const InstanceLeaves::Instance& instance) {
  const double inner = instance.aggregate->reach();
  if (instance.part_begin) return inner;
  return reach_of(transform_box(instance.to_outer, {Vec3{-inner, -inner, -inner}, Vec3{inner, inner, inner}}));
}

template <class Leaves>
void arrange(Leaves& leaves) {
  if constexpr (requires { leaves.arrange(); }) leaves.arrange();
}

} // namespace

bool NearestQuery::offer(const Hit& hit, std::uint32_t slot, std::uint32_t index, const LeafKind& kind,
                         const void* leaves) {
  bool is_contested = false;
  if (best && hit.t >= best.t) {
    best.is_contested = true;
    if (hit.t > best.t) return false;
    const std::uint32_t other = best.kind->tag(best.leaves, best.index).slot;
    const std::uint64_t order = base + aggregate.order(slot), best_order = best.base + best.aggregate->order(other);
    if (best_order < order || (best_order == order && !is_before(leaves, index, best))) return false;
    is_contested = true;
  } else if (best) {
    is_contested = best.t <= slack.end(hit.t);
  }
  interval.upper = slack.end(hit.t);
  best = {hit, index, 0, false, is_contested, &kind, leaves, &aggregate, base};
  return true;
}

void ShadowQuery::add_attenuation(double t, std::uint32_t slot, std::uint32_t sequence, const Color& transmittance) {
  scratch.attenuations.push_back({t, base + aggregate.order(slot), sequence, transmittance});
}

void InspectQuery::add_hit(const Boundary& hit, std::uint32_t index, const LeafKind& kind, const void* leaves) {
  hits->push_back({hit, index, hit.operand, hit.is_flipped, false, &kind, leaves, &aggregate, base});
}

void InspectQuery::add_around(std::uint32_t slot, BindingId medium) {
  around->push_back({base + aggregate.order(slot), bindings.ior(medium), bindings.material(medium)});
}

void Aggregate::nearest(NearestQuery& query) const {
  for (const LooseLeaf& leaf : loose_leaves_) leaf.kind->nearest(leaf.leaves, leaf.index, query);
  if (!tree_.is_empty()) tree_.nearest(query);
}

bool Aggregate::blocks(ShadowQuery& query) const {
  for (const LooseLeaf& leaf : loose_leaves_)
    if (leaf.kind->blocks(leaf.leaves, leaf.index, query)) return true;
  return !tree_.is_empty() && tree_.blocks(query);
}

void Aggregate::nearest(std::span<bvh::Query* const> queries) const {
  for (const LooseLeaf& leaf : loose_leaves_)
    for (bvh::Query* query : queries) leaf.kind->nearest(leaf.leaves, leaf.index, static_cast<NearestQuery&>(*query));
  if (!tree_.is_empty()) tree_.nearest(queries);
}

std::array<bool, bvh::packet_size> Aggregate::blocks(std::span<bvh::Query* const> queries) const {
  std::array<bool, bvh::packet_size> answers{};
  if (!tree_.is_empty()) answers = tree_.blocks(queries);
  for (const LooseLeaf& leaf : loose_leaves_)
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i] = answers[i] || leaf.kind->blocks(leaf.leaves, leaf.index, static_cast<ShadowQuery&>(*queries[i]));
  return answers;
}

std::uint64_t Aggregate::order(std::uint32_t slot) const {
  const auto after = std::partition_point(steps_.begin(), steps_.end(), [&](const Step& s) { return s.slot < slot; });
  if (after == steps_.begin()) return slot;
  const Step& step = *(after - 1);
  return step.order + step.object_count + (slot - step.slot - 1);
}

const Aggregate::Step* Aggregate::step_to(std::uint64_t order, std::uint32_t& slot) const {
  const auto after =
      std::partition_point(steps_.begin(), steps_.end(), [&](const Step& s) { return s.order <= order; });
  if (after == steps_.begin()) {
    slot = static_cast<std::uint32_t>(order);
    return nullptr;
  }
  const Step& step = *(after - 1);
  slot = step.slot;
  if (order < step.order + step.object_count) return &step;
  slot += static_cast<std::uint32_t>(order - step.order - step.object_count) + 1;
  return nullptr;
}

std::vector<std::uint32_t> Aggregate::path(std::uint32_t slot) const {
  const auto after = std::partition_point(runs_.begin(), runs_.end(), [&](const Run& r) { return r.slot <= slot; });
  assert(after != runs_.begin());
  const Run& run = *(after - 1);
  std::vector<std::uint32_t> path{run.position + (slot - run.slot)};
  for (std::uint32_t i = run.source; i != 0; i = sources_[i].parent) path.push_back(sources_[i].position);
  std::reverse(path.begin(), path.end());
  return path;
}

std::uint32_t AggregateBuilder::add_source(std::uint32_t parent, std::uint32_t position) {
  aggregate_.sources_.push_back({parent, position});
  return static_cast<std::uint32_t>(aggregate_.sources_.size() - 1);
}

std::uint32_t AggregateBuilder::add_object(std::uint32_t source, std::uint32_t position) {
  auto& runs = aggregate_.runs_;
  const std::uint32_t slot = slot_count_++;
  if (runs.empty() || runs.back().source != source || runs.back().position + (slot - runs.back().slot) != position)
    runs.push_back({slot, source, position});
  return slot;
}

LeafSets& AggregateBuilder::sets_for(const Box3& box) {
  aggregate_.box_.extend(box);
  return box.is_finite() ? aggregate_.bounded_ : aggregate_.unbounded_;
}

void AggregateBuilder::add_solid(const SolidLeaves::PlacedSolid& solid, LeafTag tag) {
  if (!solid.box.is_empty()) sets_for(solid.box).all<SolidLeaves>().add(solid, tag);
}

void AggregateBuilder::add_instance(const Aggregate& aggregate, const Affine& map, LeafTag tag) {
  const Box3 box = transform_box(map, aggregate.box());
  const Affine to_local = box.is_empty() ? Affine{} : scene::inverse_of_nested(map);
  add_instance({&aggregate, map, to_local, aggregate_.order(tag.slot)}, box, tag);
}

void AggregateBuilder::add_part(const Aggregate& aggregate, std::uint32_t begin, LeafTag tag) {
  add_instance({&aggregate, {}, {}, aggregate_.order(tag.slot), begin}, aggregate.box(), tag);
}

void AggregateBuilder::add_instance(const InstanceLeaves::Instance& instance, const Box3& box, LeafTag tag) {
  Aggregate::Step& step = aggregate_.steps_.emplace_back(
      Aggregate::Step{nullptr, 0, tag.slot, instance.order, instance.aggregate->object_count()});
  if (box.is_empty()) return;
  InstanceLeaves& leaves = sets_for(box).all<InstanceLeaves>();
  step.leaves = &leaves;
  step.index = leaves.size();
  leaves.add(instance, tag);
}

void AggregateBuilder::add_loose(const LeafSets& sets) {
  sets.for_each([&]<class Leaves>(const Leaves& leaves) {
    for (std::uint32_t i = 0; i < leaves.size(); ++i)
      aggregate_.loose_leaves_.push_back({&leaf_kind<Leaves>, &leaves, i});
  });
}

void AggregateBuilder::build(const bvh::Device& device) {
  Aggregate& a = aggregate_;
  a.object_count_ = a.order(slot_count_);
  Box3 box;
  std::size_t count = 0;
  for (LeafSets* sets : {&a.bounded_, &a.unbounded_}) sets->for_each([](auto& leaves) { arrange(leaves); });
  std::as_const(a.bounded_).for_each([&](const auto& leaves) {
    for (std::uint32_t i = 0; i < leaves.size(); ++i) box.extend(leaves.bounds(i));
    count += leaves.size();
  });
  a.reach_ = reach_of(box);
  const auto& unbounded = a.unbounded_.all<InstanceLeaves>();
  for (std::uint32_t i = 0; i < unbounded.size(); ++i) a.reach_ = std::max(a.reach_, reach_of(unbounded.instance(i)));
  add_loose(a.unbounded_);
  if (count == 0) return;
  const bool has_large = a.bounded_.all<InstanceLeaves>().size() + a.bounded_.all<SolidLeaves>().size() > 0;
  if (count < least_for_tree && !has_large) return add_loose(a.bounded_);
  a.tree_ = bvh::Tree(device, box);
  std::as_const(a.bounded_).for_each([&](const auto& leaves) { a.tree_.add<NearestQuery, ShadowQuery>(leaves); });
  a.tree_.build();
}

} // namespace rt
