#include "renderer/compile/csg.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/scene/validation/validate.hpp"

#include <algorithm>
#include <span>

namespace rt {
namespace {

// With fewer children it is faster to test each.
constexpr std::size_t least_for_index = 8;

// Whether an operand can be replaced by its own operands: a ∪ (b ∪ c), a ∩ (b ∩ c), (a − b) − c, a − (b ∪ c).
bool dissolves(CsgSolid::Operation outer, CsgSolid::Operation inner, bool is_first) {
  using enum scene::Combination::Operation;
  if (outer != subtract) return inner == outer;
  return is_first ? inner == subtract : inner == unite;
}

} // namespace

// The operands of a combination, during their traversal.
struct CsgBuilder::ListFrame {
  std::span<const scene::Object> objects;
  std::uint32_t node;  // that they become children of
  bool is_subtraction; // what follows the node's first child is subtracted from it
  Affine map;          // from their parent's space to the solid's
  BindingId binding;   // that they inherit
  bool casts_shadow;
  std::uint32_t source;
  std::size_t next = 0;
};

CsgSolid CsgBuilder::build(const scene::Combination& combination, const Affine& map) {
  CsgSolid solid;
  solid.sources_.push_back({0, 0});
  solid.nodes_.push_back({combination.operation, {}, nullptr});
  const bool subtracts = combination.operation == CsgSolid::Operation::subtract;
  std::vector<ListFrame> frames{{combination.operands, 0, subtracts, map, inherited_binding, true, 0}};
  while (!frames.empty()) visit(solid, frames);
  for (CsgSolid::Node& node : solid.nodes_) add_index(solid, node);
  return solid;
}

// One step: the next operand of the innermost frame. Not recursive, because solids may be deeply nested.
void CsgBuilder::visit(CsgSolid& solid, std::vector<ListFrame>& frames) {
  ListFrame& frame = frames.back();
  const auto position = static_cast<std::uint32_t>(frame.next++);
  // If there is nothing to subtract from, the result is empty.
  const bool is_void = frame.is_subtraction && position > 0 && solid.nodes_[frame.node].children.empty();
  if (position >= frame.objects.size() || is_void) {
    frames.pop_back();
    return;
  }
  const scene::Object& object = frame.objects[position];
  if (!object.is_visible) return;
  const auto source = static_cast<std::uint32_t>(solid.sources_.size());
  solid.sources_.push_back({frame.source, position});

  if (!refers_to_composite(object.shape)) {
    add_operand(solid, frame, object, source);
    return;
  }
  const auto& combination = scene_.shapes.get<scene::Combination>(object.shape);
  ListFrame inner = frame;
  inner.next = 0;
  inner.source = source;
  inner.map = frame.map * to_parent(scene_, object);
  inner.casts_shadow = frame.casts_shadow && object.casts_shadow;
  inner.binding = bindings_.of(object, inner.map, frame.binding);
  if (object.material != scene::no_material) add_medium(solid, inner.binding);
  inner.objects = combination.operands;
  CsgSolid::Node& node = solid.nodes_[frame.node];
  const bool is_first = frame.is_subtraction && position == 0;
  inner.is_subtraction = combination.operation == CsgSolid::Operation::subtract;
  if (!dissolves(node.operation, combination.operation, is_first)) {
    inner.node = static_cast<std::uint32_t>(solid.nodes_.size());
    node.children.push_back({inner.node, true});
    solid.nodes_.push_back({combination.operation, {}, nullptr});
  }
  frames.push_back(inner);
}

// Candidates after the first that certainly applies do not matter.
void CsgBuilder::add_medium(CsgSolid& solid, BindingId binding) const {
  auto& media = solid.media_;
  if (binding != inherited_binding && !bindings_.uses_ior(binding)) return;
  if (media.empty() || (media.back() == inherited_binding && binding != inherited_binding)) media.push_back(binding);
}

void CsgBuilder::add_operand(CsgSolid& solid, const ListFrame& frame, const scene::Object& object,
                             std::uint32_t source) {
  const Affine map = frame.map * to_parent(scene_, object);
  const BindingId binding = bindings_.of(object, map, frame.binding);
  add_medium(solid, binding);
  const bool casts_shadow = frame.casts_shadow && object.casts_shadow;
  const auto add = [&](SolidShape shape) {
    solid.nodes_[frame.node].children.push_back({static_cast<std::uint32_t>(solid.operands_.size()), false});
    const Box3 box = std::visit([](const auto& placed) { return placed.box(); }, shape);
    if (box.is_finite()) solid.reach_ = std::max(solid.reach_, reach_of(box));
    solid.operands_.push_back({std::move(shape), binding, casts_shadow, source});
  };
  scene_.shapes.visit(object.shape, [&]<class S>(const S& shape) {
    if constexpr (!scene::is_composite<S>) {
      if constexpr (Solidlike<GeometryOf<S>>) {
        for_each_geometry(shape, rules_, [&]<class G>(const G& own) {
          if (const std::optional<G> here = placed(own, map)) return add(Baked<G>{*here});
          add(Transformed<G>{own, map, scene::inverse_of_nested(map)});
        });
      }
    }
  });
}

void CsgBuilder::add_index(CsgSolid& solid, CsgSolid::Node& node) {
  const bool subtracts = node.operation == CsgSolid::Operation::subtract;
  const std::size_t first = subtracts ? 1 : 0;
  if (node.operation == CsgSolid::Operation::intersect || node.children.size() < first + least_for_index) return;
  auto index = std::make_unique<CsgSolid::Index>();
  Box3 all;
  for (std::size_t i = first; i < node.children.size(); ++i) {
    const Box3 box = solid.box_of(node.children[i], {});
    if (box.is_empty()) continue;
    const auto child = static_cast<std::uint32_t>(i);
    if (!box.is_finite()) {
      index->others.push_back(child);
      continue;
    }
    all.extend(box);
    index->boxes.boxes.push_back(box);
    index->boxes.children.push_back(child);
  }
  if (index->boxes.size() < least_for_index) return;
  index->tree = bvh::Tree(device_, all);
  index->tree.add<LineQuery, LineQuery>(index->boxes);
  index->tree.build();
  node.index = std::move(index);
}

} // namespace rt
