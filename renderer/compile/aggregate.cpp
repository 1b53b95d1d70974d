#include "renderer/compile/aggregate.hpp"

#include <algorithm>
#include <cassert>

namespace rt {

bool NearestQuery::offer(const Hit& hit, std::uint32_t slot, std::uint32_t index, const LeafKind& kind,
                         const void* leaves) {
  if (best && hit.t == best.t) {
    const std::uint32_t other = best.kind->tag(best.leaves, best.index).slot;
    if (best.base + best.aggregate->order(other) <= base + aggregate.order(slot)) return false;
  }
  interval.upper = hit.t;
  best = {hit.t, hit.part, index, 0, false, &kind, leaves, &aggregate, base};
  return true;
}

void ShadowQuery::add_attenuation(double t, std::uint32_t slot, std::uint32_t sequence, const Color& transmittance) {
  scratch.attenuations.push_back({t, base + aggregate.order(slot), sequence, transmittance});
}

void InspectQuery::add_hit(const Boundary& hit, std::uint32_t index, const LeafKind& kind, const void* leaves) {
  hits->push_back({hit.t, hit.shape_part, index, hit.operand, hit.is_flipped, &kind, leaves, &aggregate, base});
}

void InspectQuery::add_around(std::uint32_t slot, double ior) {
  around->push_back({base + aggregate.order(slot), ior});
}

void Aggregate::nearest(NearestQuery& query) const {
  for (const Unbounded& leaf : unbounded_leaves_) leaf.kind->nearest(leaf.leaves, leaf.index, query);
  if (!tree_.is_empty()) tree_.nearest(query);
}

bool Aggregate::blocks(ShadowQuery& query) const {
  for (const Unbounded& leaf : unbounded_leaves_)
    if (leaf.kind->blocks(leaf.leaves, leaf.index, query)) return true;
  return !tree_.is_empty() && tree_.blocks(query);
}

void Aggregate::nearest(std::span<bvh::Query* const> queries) const {
  for (const Unbounded& leaf : unbounded_leaves_)
    for (bvh::Query* query : queries) leaf.kind->nearest(leaf.leaves, leaf.index, static_cast<NearestQuery&>(*query));
  if (!tree_.is_empty()) tree_.nearest(queries);
}

std::array<bool, bvh::packet_size> Aggregate::blocks(std::span<bvh::Query* const> queries) const {
  std::array<bool, bvh::packet_size> answers{};
  if (!tree_.is_empty()) answers = tree_.blocks(queries);
  for (const Unbounded& leaf : unbounded_leaves_)
    for (std::size_t i = 0; i < queries.size(); ++i)
      answers[i] = answers[i] || leaf.kind->blocks(leaf.leaves, leaf.index, static_cast<ShadowQuery&>(*queries[i]));
  return answers;
}

std::uint64_t Aggregate::order(std::uint32_t slot) const {
  const auto after = std::partition_point(steps_.begin(), steps_.end(), [&](const Step& s) { return s.slot < slot; });
  if (after == steps_.begin()) return slot;
  const Step& step = *(after - 1);
  return step.order + step.leaf_count + (slot - step.slot - 1);
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
  if (order < step.order + step.leaf_count) return &step;
  slot += static_cast<std::uint32_t>(order - step.order - step.leaf_count) + 1;
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

} // namespace rt
