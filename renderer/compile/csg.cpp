#include "renderer/compile/csg.hpp"

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

// Sweeps along the line over the surfaces in list[begin…], and keeps those where the number of solids that contain the
// point, `depth` at first, reaches `threshold` or falls below.
void sweep(std::vector<Boundary>& list, std::size_t begin, std::size_t depth, std::size_t threshold) {
  std::size_t kept = begin;
  for (std::size_t i = begin; i < list.size();) {
    const bool was_inside = depth >= threshold;
    const std::size_t first = i;
    for (; i < list.size() && list[i].t == list[first].t; ++i) list[i].is_entry ? ++depth : --depth;
    const bool is_inside = depth >= threshold;
    if (was_inside == is_inside) continue;
    std::size_t turning = first;
    while (list[turning].is_entry != is_inside) ++turning;
    list[kept++] = Boundary(list[turning]);
  }
  list.resize(kept);
}

} // namespace

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

void CsgSolid::push_node(std::uint32_t index, const Ray& ray, TraceScratch& scratch) const {
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
      push_child(node, looked_at, ray, scratch);
      if (list.size() == before) return list.resize(begin);
    }
  }
  if (node.index) {
    const std::size_t mark = scratch.operands.size();
    scratch.operands.insert(scratch.operands.end(), node.index->others.begin(), node.index->others.end());
    LineQuery query(ray, scratch.operands);
    if (!node.index->tree.is_empty()) node.index->tree.blocks(query);
    std::sort(scratch.operands.begin() + static_cast<std::ptrdiff_t>(mark), scratch.operands.end());
    for (std::size_t i = mark; i < scratch.operands.size(); ++i) push_child(node, scratch.operands[i], ray, scratch);
    scratch.operands.resize(mark);
  } else {
    for (; looked_at < count; ++looked_at) push_child(node, looked_at, ray, scratch);
  }
  sort(list, begin);
  // To be inside a difference is to be inside the first operand and the complements of all the others, which contain
  // the line's beginning.
  if (subtracts)
    sweep(list, begin, count - 1, count);
  else
    sweep(list, begin, 0, node.operation == Operation::unite ? 1 : count);
}

void CsgSolid::push_child(const Node& node, std::uint32_t i, const Ray& ray, TraceScratch& scratch) const {
  std::vector<Boundary>& list = scratch.boundaries;
  const std::size_t begin = list.size();
  const Child& child = node.children[i];
  if (child.is_node) {
    push_node(child.index, ray, scratch);
  } else {
    const auto push = [&](const auto& placed) {
      bool is_entry = true;
      for (const Hit& hit : crossings(placed.shape, placed.carried(ray))) {
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
  SurfacePoint p = std::visit([&](const auto& placed) { return placed.point(ray, hit); }, operands_[hit.operand].shape);
  if (hit.is_flipped) p.normal = -p.normal;
  return p;
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
