#include "renderer/compile/compile.hpp"

#include "renderer/compile/instancing.hpp"
#include "renderer/scene/validate.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace rt {
namespace {

// Fewer shapes are faster to go through than a tree. What is more than a shape is worth the test of its box, and the
// order from near to far: without it a group of groups of groups costs as much as all its copies.
constexpr std::size_t least_for_tree = 4;

// Objects of one list on the way through the groups that are taken apart.
struct ListFrame {
  std::span<const scene::Object> objects;
  Affine map;        // from their parent's space to the assembly's
  BindingId binding; // that they inherit
  bool casts_shadow;
  std::uint32_t source;
  std::size_t next = 0;
};

/// What is left of a list between and around its parts.
std::vector<std::span<const scene::Object>> outside_of(std::span<const Part> parts,
                                                       std::span<const scene::Object> objects) {
  std::vector<std::span<const scene::Object>> ranges;
  std::size_t begin = 0;
  for (const Part& part : parts) {
    ranges.push_back(objects.subspan(begin, part.begin - begin));
    begin = part.end;
  }
  ranges.push_back(objects.subspan(begin));
  return ranges;
}

} // namespace

class Compiler {
public:
  // Compiles the `objects`, which are the scene's or a part of them. `parts` (by position among them) are ready.
  Compiler(Compiled& compiled, const scene::Scene& scene, std::span<const scene::Object> objects,
           std::span<const Part> parts)
      : compiled_(compiled), bindings_(*compiled.bindings_), scene_(scene), objects_(objects), parts_(parts),
        instancing_(scene, outside_of(parts, objects)), solid_builder_(scene, *compiled.device_, bindings_),
        group_assemblies_(scene.shapes.all<scene::Group>().size()),
        shared_solids_(scene.shapes.all<scene::Combination>().size()) {}

  void run() {
    for (const std::uint32_t group : instancing_.instanced())
      group_assemblies_[group] = compile(scene_.shapes.all<scene::Group>()[group].members, inherited_binding);
    compile(objects_, bindings_.default_binding(), true);
  }

private:
  const Aggregate* compile(std::span<const scene::Object> objects, BindingId binding, bool is_root = false) {
    compiled_.aggregates_.push_back(std::make_unique<Aggregate>());
    Aggregate& aggregate = *compiled_.aggregates_.back();
    aggregate_ = &aggregate;
    slot_count_ = 0;
    if (is_root)
      for (const auto stretch : outside_of(parts_, objects_)) reserve(stretch);
    else
      reserve(objects);
    next_part_ = is_root ? 0 : parts_.size();
    std::vector<ListFrame> frames{{objects, {}, binding, true, 0}};
    while (!frames.empty()) visit(frames);
    aggregate.leaf_count_ = aggregate.order(slot_count_);
    build();
    return &aggregate;
  }

  // One step: the next object of the innermost frame. There is no recursion, because groups may nest deep.
  void visit(std::vector<ListFrame>& frames) {
    ListFrame& frame = frames.back();
    if (frame.next == frame.objects.size()) return frames.pop_back();
    const auto position = static_cast<std::uint32_t>(frame.next++);
    if (next_part_ < parts_.size() && frame.source == 0 && parts_[next_part_].begin == position) {
      frame.next = parts_[next_part_].end;
      return add_part(next_part_++);
    }
    const scene::Object& object = frame.objects[position];
    if (!object.is_visible) return;
    const Affine map = placed_in(frame.map, object);
    const BindingId binding = bindings_.of(object, map, frame.binding);
    const bool casts_shadow = frame.casts_shadow && object.casts_shadow;
    if (object.shape.kind == scene::kind_of<scene::Group> && !instancing_.is_instanced(object.shape.index)) {
      const auto source = static_cast<std::uint32_t>(aggregate_->sources_.size());
      aggregate_->sources_.push_back({frame.source, position});
      frames.push_back({scene_.shapes.get<scene::Group>(object.shape).members, map, binding, casts_shadow, source});
      return;
    }
    add(object, map, LeafTag(new_slot(frame.source, position), binding, casts_shadow));
  }

  // Most objects of a large scene are only moved.
  Affine placed_in(const Affine& outer, const scene::Object& object) const {
    if (object.transform == scene::no_transform) return {outer.x, outer.y, outer.z, outer.point(object.at)};
    return outer * to_parent(scene_, object);
  }

  std::uint32_t new_slot(std::uint32_t source, std::uint32_t position) {
    auto& runs = aggregate_->runs_;
    const std::uint32_t slot = slot_count_++;
    if (runs.empty() || runs.back().source != source || runs.back().position + (slot - runs.back().slot) != position)
      runs.push_back({slot, source, position});
    return slot;
  }

  void add(const scene::Object& object, const Affine& map, LeafTag tag) {
    scene_.shapes.visit(object.shape, [&]<class S>(const S& shape) {
      if constexpr (std::is_same_v<S, scene::Group>) {
        add_instance(object.shape.index, map, tag);
      } else if constexpr (std::is_same_v<S, scene::Combination>) {
        add_solid(object, shape, map, tag);
      } else if constexpr (std::is_same_v<S, scene::Triangle>) {
        if (shape.normals.size() == 3)
          add_shape(SmoothTriangleGeometry{geometry(shape), {shape.normals[0], shape.normals[1], shape.normals[2]}},
                    map, tag);
        else
          add_shape(geometry(shape), map, tag);
      } else {
        add_shape(geometry(shape), map, tag);
      }
    });
  }

  template <class G>
  void add_shape(const G& own, const Affine& map, LeafTag tag) {
    if (std::optional<G> here = placed(own, map))
      put<ShapeLeaves<Baked<G>>>(Baked<G>{std::move(*here)}, tag);
    else
      put<ShapeLeaves<Transformed<G>>>(Transformed<G>{own, map, scene::inverse_of_nested(map)}, tag);
  }

  template <class Leaves, class Placed>
  void put(Placed shape, LeafTag tag) {
    const Box3 box = shape.box();
    if (box.is_empty()) return;
    sets_for(box).template all<Leaves>().add(std::move(shape), tag);
  }

  LeafSets& sets_for(const Box3& box) {
    aggregate_->box_.extend(box);
    return box.is_finite() ? aggregate_->bounded_ : aggregate_->unbounded_;
  }

  void add_instance(std::uint32_t group, const Affine& map, LeafTag tag) {
    const Aggregate* aggregate = group_assemblies_[group];
    const std::uint64_t order = aggregate_->order(tag.slot);
    aggregate_->steps_.push_back({nullptr, 0, tag.slot, order, aggregate->leaf_count()});
    const Box3 box = transform_box(map, aggregate->box());
    if (box.is_empty()) return;
    const Affine to_local = scene::inverse_of_nested(map);
    InstanceLeaves& leaves = sets_for(box).all<InstanceLeaves>();
    aggregate_->steps_.back().leaves = &leaves;
    aggregate_->steps_.back().index = leaves.size();
    leaves.add({aggregate, map, to_local, order}, tag);
  }

  void add_part(std::size_t index) {
    const Aggregate& aggregate = compiled_.parts_[index]->root();
    const std::uint32_t slot = new_slot(0, parts_[index].begin);
    const std::uint64_t order = aggregate_->order(slot);
    aggregate_->steps_.push_back({nullptr, 0, slot, order, aggregate.leaf_count()});
    if (aggregate.box().is_empty()) return;
    InstanceLeaves& leaves = sets_for(aggregate.box()).all<InstanceLeaves>();
    aggregate_->steps_.back().leaves = &leaves;
    aggregate_->steps_.back().index = leaves.size();
    leaves.add({&aggregate, {}, {}, order, parts_[index].begin}, LeafTag(slot, bindings_.default_binding(), true));
  }

  void add_solid(const scene::Object& object, const scene::Combination& combination, const Affine& map, LeafTag tag) {
    const bool is_shared = instancing_.is_shared(object.shape);
    const CsgSolid*& shared = shared_solids_[object.shape.index];
    const CsgSolid* solid = shared;
    if (!solid) {
      compiled_.solids_.push_back(
          std::make_unique<CsgSolid>(solid_builder_.build(combination, is_shared ? Affine{} : map)));
      solid = compiled_.solids_.back().get();
      if (is_shared) shared = solid;
    }
    const Box3 box = is_shared ? solid->box(map) : solid->box();
    if (box.is_empty()) return;
    const Affine to_local = scene::inverse_of_nested(map);
    sets_for(box).all<SolidLeaves>().add({solid, !is_shared, object.material != scene::no_material, map, to_local, box},
                                         tag);
  }

  // Room for as many shapes as there are, so that the arrays of a large scene do not grow by doubling.
  void reserve(std::span<const scene::Object> objects) {
    scene::ShapeKinds::for_each([&]<class S>() {
      if constexpr (!scene::is_composite<S>) {
        std::size_t count = 0;
        for (const scene::Object& object : objects)
          count +=
              object.shape.kind == scene::kind_of<S> && object.transform == scene::no_transform && object.is_visible;
        if (std::is_same_v<S, scene::Plane>) return; // is not bounded
        aggregate_->bounded_.all<ShapeLeaves<Baked<GeometryOf<S>>>>().reserve(count);
      }
    });
  }

  void build() {
    Aggregate& a = *aggregate_;
    Box3 box;
    std::size_t count = 0;
    for (LeafSets* sets : {&a.bounded_, &a.unbounded_}) sets->for_each([](auto& leaves) { arrange(leaves); });
    std::as_const(a.bounded_).for_each([&](const auto& leaves) {
      for (std::uint32_t i = 0; i < leaves.size(); ++i) box.extend(leaves.bounds(i));
      count += leaves.size();
    });
    add_loose(a.unbounded_);
    if (count == 0) return;
    const bool has_large = a.bounded_.all<InstanceLeaves>().size() + a.bounded_.all<SolidLeaves>().size() > 0;
    if (count < least_for_tree && !has_large) return add_loose(a.bounded_);
    a.tree_ = bvh::Tree(*compiled_.device_, box);
    std::as_const(a.bounded_).for_each([&](const auto& leaves) { a.tree_.add<NearestQuery, ShadowQuery>(leaves); });
    a.tree_.build();
  }

  template <class Leaves>
  static void arrange(Leaves& leaves) {
    if constexpr (requires { leaves.arrange(); }) leaves.arrange();
  }

  void add_loose(const LeafSets& sets) {
    sets.for_each([&]<class Leaves>(const Leaves& leaves) {
      for (std::uint32_t i = 0; i < leaves.size(); ++i)
        aggregate_->unbounded_leaves_.push_back({&leaf_kind<Leaves>, &leaves, i});
    });
  }

  Compiled& compiled_;
  MaterialBindings& bindings_;
  const scene::Scene& scene_;
  std::span<const scene::Object> objects_;
  std::span<const Part> parts_;
  Instancing instancing_;
  CsgBuilder solid_builder_;
  std::vector<const Aggregate*> group_assemblies_; // by group
  std::vector<const CsgSolid*> shared_solids_;     // by combination

  Aggregate* aggregate_ = nullptr; // that is being made
  std::uint32_t slot_count_ = 0;
  std::size_t next_part_ = 0;
};

Compiled::Compiled(const scene::Scene& scene, int threads, bvh::Builder builder)
    : device_(std::make_shared<bvh::Device>(threads, builder)),
      bindings_(std::make_shared<MaterialBindings>(validated(scene))) {
  Compiler(*this, scene, scene.objects, {}).run();
}

Compiled::Compiled(const scene::Scene& scene, std::span<const Part> parts, CompileCache& cache) {
  require_none(validate_settings(scene));
  std::vector<std::span<const scene::Object>> fresh = outside_of(parts, scene.objects);
  for (const Part& part : parts)
    if (!cache.knows(part)) fresh.push_back(std::span(scene.objects).subspan(part.begin, part.end - part.begin));
  require_none(validate(scene, fresh));
  cache.begin(scene);
  device_ = cache.device_;
  bindings_ = cache.bindings_;
  for (const Part& part : parts) parts_.push_back(cache.take(scene, part));
  cache.mark_ = bindings_->mark();
  cache.forget_unused();
  Compiler(*this, scene, scene.objects, parts).run();
}

bool CompileCache::knows(const Part& part) const {
  return std::any_of(entries_.begin(), entries_.end(), [&](const CacheEntry& e) { return e.stamp == part.stamp; });
}

void CompileCache::begin(const scene::Scene& scene) {
  ++uses_;
  if (!bindings_) {
    bindings_ = std::make_shared<MaterialBindings>(scene);
    return;
  }
  bindings_->release(mark_);
  bindings_->extend(scene);
}

std::shared_ptr<const Compiled> CompileCache::take(const scene::Scene& scene, const Part& part) {
  const std::uint32_t size = part.end - part.begin;
  for (CacheEntry& entry : entries_) {
    if (entry.stamp != part.stamp) continue;
    entry.last_use = uses_;
    ++counts_.parts_reused;
    counts_.objects_reused += size;
    return entry.compiled;
  }
  const std::shared_ptr<Compiled> made(new Compiled(device_, bindings_));
  Compiler(*made, scene, std::span(scene.objects).subspan(part.begin, size), {}).run();
  ++counts_.parts_built;
  counts_.objects_built += size;
  entries_.push_back({part.stamp, uses_, made});
  return made;
}

void CompileCache::forget_unused() {
  std::erase_if(entries_, [this](const CacheEntry& entry) { return entry.last_use + patience < uses_; });
}

} // namespace rt
