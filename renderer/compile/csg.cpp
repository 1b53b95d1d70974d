#include "renderer/compile/csg.hpp"

#include "renderer/math/rounding.hpp"

#include <algorithm>

namespace rt {
namespace {

// Lists are short and consist of sorted runs. Equal distances stay in the order of declaration.
void sort(std::vector<Boundary>& list, std::size_t begin) {
  for (std::size_t i = begin + 1; i < list.size(); ++i) {
    const Boundary moved = list[i];
    std::size_t at = i;
    for (; at > begin && list[at - 1].t > moved.t; --at) list[at] = list[at - 1];
    list[at] = moved;
  }
}

} // namespace

// Walks along the line past the surfaces in list[begin…], and keeps those where the number of solids that it is inside
// of, `depth` at first, reaches `threshold` or falls below.
void CsgSolid::sweep(const Line& line, std::vector<Boundary>& list, std::size_t begin, std::size_t depth,
                     std::size_t threshold) const {
  std::size_t kept = begin;
  for (std::size_t i = begin; i < list.size();) {
    const bool was_inside = depth >= threshold;
    const std::size_t first = i, end = end_of_place(line, list, first);
    for (; i < end; ++i) list[i].is_entry ? ++depth : --depth;
    const bool is_inside = depth >= threshold;
    if (was_inside == is_inside) continue;
    const Boundary* turning = nullptr;
    for (std::size_t k = first; k < end; ++k)
      if (list[k].is_entry == is_inside && (!turning || list[k].operand < turning->operand)) turning = &list[k];
    list[kept++] = Boundary(*turning);
  }
  list.resize(kept);
}

// The position after the last of the boundaries that are crossed at once with that one.
std::size_t CsgSolid::end_of_place(const Line& line, const std::vector<Boundary>& list, std::size_t first) const {
  const double t = list[first].t, near = line.slack.end(t);
  std::size_t end = first + 1;
  while (end < list.size() && list[end].t == t) ++end;
  if (end == list.size() || !(list[end].t <= near)) [[likely]]
    return end;
  const SurfacePoint place = operand_point(list[first].operand, line.ray, list[first]);
  while (end < list.size() && list[end].t <= near &&
         touch(place, operand_point(list[end].operand, line.ray, list[end])))
    ++end;
  return end;
}

Slack CsgSolid::slack(const Ray& ray) const {
  return {0x1p-30 * (magnitude(ray.origin) + reach_) / max_component(abs(ray.direction))};
}

Box3 CsgSolid::box_of(const Child& child, const Affine& map) const {
  if (child.is_node) return box_of(child.index, map);
  return std::visit([&](const auto& shape) { return shape.box(map); }, operands_[child.index].shape);
}

Box3 CsgSolid::box_of(std::uint32_t index, const Affine& map) const {
  const Node& node = nodes_[index];
  if (node.children.empty()) return {};
  Box3 box = box_of(node.children.front(), map);
  for (std::size_t i = 1; i < node.children.size() && node.operation != Operation::subtract; ++i) {
    const Box3 other = box_of(node.children[i], map);
    if (node.operation == Operation::unite)
      box.extend(other);
    else
      box = overlap(box, other);
  }
  return box;
}

void CsgSolid::push_node(std::uint32_t index, const Line& line, TraceScratch& scratch) const {
  const Node& node = nodes_[index];
  std::vector<Boundary>& list = scratch.boundaries;
  const std::size_t begin = list.size(), count = node.children.size();
  const bool subtracts = node.operation == Operation::subtract;

  // If the line misses one of these, the result is empty.
  std::uint32_t looked_at = 0;
  if (node.operation != Operation::unite) {
    const std::uint32_t needed = subtracts ? 1 : static_cast<std::uint32_t>(count);
    for (; looked_at < needed && looked_at < count; ++looked_at) {
      const std::size_t before = list.size();
      push_child(node, looked_at, line, scratch);
      if (list.size() == before) return list.resize(begin);
    }
  }
  if (node.index) {
    const std::size_t mark = scratch.operands.size();
    scratch.operands.insert(scratch.operands.end(), node.index->others.begin(), node.index->others.end());
    LineQuery query(line.ray, scratch.operands);
    if (!node.index->tree.is_empty()) node.index->tree.blocks(query);
    std::sort(scratch.operands.begin() + static_cast<std::ptrdiff_t>(mark), scratch.operands.end());
    for (std::size_t i = mark; i < scratch.operands.size(); ++i) push_child(node, scratch.operands[i], line, scratch);
    scratch.operands.resize(mark);
  } else {
    for (; looked_at < count; ++looked_at) push_child(node, looked_at, line, scratch);
  }
  sort(list, begin);
  // To be inside a difference is to be inside the first operand and the complements of all the others, which contain
  // the line's beginning.
  if (subtracts)
    sweep(line, list, begin, count - 1, count);
  else
    sweep(line, list, begin, 0, node.operation == Operation::unite ? 1 : count);
}

void CsgSolid::push_child(const Node& node, std::uint32_t i, const Line& line, TraceScratch& scratch) const {
  std::vector<Boundary>& list = scratch.boundaries;
  const std::size_t begin = list.size();
  const Child& child = node.children[i];
  if (child.is_node) {
    push_node(child.index, line, scratch);
  } else {
    const auto push = [&](const auto& placed) {
      bool is_entry = true;
      for (const Hit& hit : crossings(placed.shape, placed.carried(line.ray))) {
        list.push_back({hit, child.index, false, is_entry});
        is_entry = !is_entry;
      }
    };
    std::visit(push, operands_[child.index].shape);
  }
  if (node.operation != Operation::subtract || i == 0) return;
  for (std::size_t k = begin; k < list.size(); ++k) {
    list[k].is_flipped = !list[k].is_flipped;
    list[k].is_entry = !list[k].is_entry;
  }
}

bool CsgSolid::child_contains(const Child& child, const Vec3& p) const {
  if (child.is_node) return node_contains(child.index, p);
  return std::visit([&](const auto& placed) { return rt::contains(placed.shape, placed.carried(p)); },
                    operands_[child.index].shape);
}

bool CsgSolid::node_contains(std::uint32_t index, const Vec3& p) const {
  const Node& node = nodes_[index];
  const auto is_around = [&](const Child& child) { return child_contains(child, p); };
  const auto begin = node.children.begin(), end = node.children.end();
  if (begin == end) return false;
  switch (node.operation) {
  case Operation::unite:
    return std::any_of(begin, end, is_around);
  case Operation::intersect:
    return std::all_of(begin, end, is_around);
  case Operation::subtract:
    return is_around(*begin) && std::none_of(begin + 1, end, is_around);
  }
  return false;
}

SurfacePoint CsgSolid::point(const Ray& ray, const RayHit& hit) const {
  SurfacePoint p = operand_point(hit.operand, ray, hit);
  if (hit.is_flipped) p.normal = -p.normal;
  return p;
}

SurfacePoint CsgSolid::operand_point(std::uint32_t operand, const Ray& ray, const Hit& hit) const {
  return std::visit([&](const auto& placed) { return placed.point(ray, hit); }, operands_[operand].shape);
}

std::vector<std::uint32_t> CsgSolid::path(std::uint32_t operand) const {
  std::vector<std::uint32_t> path;
  for (std::uint32_t i = operands_[operand].source; i != 0; i = sources_[i].parent)
    path.push_back(sources_[i].position);
  std::reverse(path.begin(), path.end());
  return path;
}

BindingId CsgSolid::medium(const MaterialBindings& bindings, BindingId inherited) const {
  for (const BindingId candidate : media_) {
    const BindingId binding = candidate == inherited_binding ? inherited : candidate;
    if (bindings.uses_ior(binding)) return binding;
  }
  return MaterialBindings::default_binding();
}

bool CsgSolid::is_medium(const MaterialBindings& bindings, BindingId inherited) const {
  return std::any_of(operands_.begin(), operands_.end(), [&](const Operand& operand) {
    return bindings.is_medium(operand.binding == inherited_binding ? inherited : operand.binding);
  });
}

} // namespace rt
