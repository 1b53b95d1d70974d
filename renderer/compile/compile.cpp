#include "renderer/compile/compile.hpp"

#include "renderer/compile/aggregate.hpp"
#include "renderer/compile/instancing.hpp"
#include "renderer/scene/validation/validate.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace rt {
namespace {

// The objects of a list during the traversal of groups that are flattened.
struct ListFrame {
  std::span<const scene::Object> objects;
  Affine map;        // from their parent's space to the aggregate's
  BindingId binding; // that they inherit
  bool casts_shadow;
  std::uint32_t source;
  std::size_t next = 0;
};

// The objects of a list between and around its parts.
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

class Compiler {
public:
  Compiler(CompiledObjects& compiled, const scene::Scene& scene, std::span<const scene::Object> objects,
           const bvh::Device& device, MaterialBindings& bindings, std::span<const Part> parts, HitRules rules)
      : compiled_(compiled), device_(device), bindings_(bindings), scene_(scene), objects_(objects), parts_(parts),
        rules_(rules), instancing_(scene, to_be_shared()), csg_builder_(scene, device, bindings, rules),
        group_aggregates_(scene.shapes.all<scene::Group>().size()),
        shared_solids_(scene.shapes.all<scene::Combination>().size()) {}

  void run() {
    for (const std::uint32_t group : instancing_.instanced())
      group_aggregates_[group] = compile(scene_.shapes.all<scene::Group>()[group].members, inherited_binding);
    compile(objects_, bindings_.default_binding(), true);
  }

private:
  // POV-Ray shares nothing: its bounding boxes are those of the copies.
  std::vector<std::span<const scene::Object>> to_be_shared() const {
    return rules_ == HitRules::povray ? std::vector<std::span<const scene::Object>>{} : outside_of(parts_, objects_);
  }

  const Aggregate* compile(std::span<const scene::Object> objects, BindingId binding, bool is_root = false) {
    compiled_.aggregates.push_back(std::make_unique<Aggregate>());
    Aggregate& aggregate = *compiled_.aggregates.back();
    AggregateBuilder builder(aggregate);
    builder_ = &builder;
    if (is_root)
      for (const auto range : outside_of(parts_, objects_)) reserve(range);
    else
      reserve(objects);
    next_part_ = is_root ? 0 : parts_.size();
    std::vector<ListFrame> frames{{objects, {}, binding, true, 0}};
    while (!frames.empty()) visit(frames);
    builder.build(device_);
    return &aggregate;
  }

  // One step: the next object of the innermost frame. Not recursive, because groups may be deeply nested.
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
      const std::uint32_t source = builder_->add_source(frame.source, position);
      frames.push_back({scene_.shapes.get<scene::Group>(object.shape).members, map, binding, casts_shadow, source});
      return;
    }
    add(object, map, LeafTag(builder_->add_object(frame.source, position), binding, casts_shadow));
  }

  // Most objects of a large scene are only translated.
  Affine placed_in(const Affine& outer, const scene::Object& object) const {
    if (object.transform == scene::no_transform) return {outer.x, outer.y, outer.z, outer.point(object.at)};
    return outer * to_parent(scene_, object);
  }

  void add(const scene::Object& object, const Affine& map, LeafTag tag) {
    scene_.shapes.visit(object.shape, [&]<class S>(const S& shape) {
      if constexpr (std::is_same_v<S, scene::Group>)
        builder_->add_instance(*group_aggregates_[object.shape.index], map, tag);
      else if constexpr (std::is_same_v<S, scene::Combination>)
        add_solid(object, shape, map, tag);
      else
        for_each_geometry(shape, rules_, [&](const auto& own) { builder_->add_shape(own, map, tag); });
    });
  }

  void add_part(std::size_t index) {
    const std::uint32_t begin = parts_[index].begin;
    builder_->add_part(compiled_.parts[index]->root(), begin,
                       LeafTag(builder_->add_object(0, begin), bindings_.default_binding(), true));
  }

  void add_solid(const scene::Object& object, const scene::Combination& combination, const Affine& map, LeafTag tag) {
    const bool is_shared = instancing_.is_shared(object.shape);
    const CsgSolid*& shared = shared_solids_[object.shape.index];
    const CsgSolid* solid = shared;
    if (!solid) {
      compiled_.solids.push_back(
          std::make_unique<CsgSolid>(csg_builder_.build(combination, is_shared ? Affine{} : map)));
      solid = compiled_.solids.back().get();
      if (is_shared) shared = solid;
    }
    const Box3 box = is_shared ? solid->box(map) : solid->box();
    if (box.is_empty()) return;
    builder_->add_solid(
        {solid, !is_shared, object.material != scene::no_material, map, scene::inverse_of_nested(map), box}, tag);
  }

  void reserve(std::span<const scene::Object> objects) {
    scene::ShapeKinds::for_each([&]<class S>() {
      if constexpr (!scene::is_composite<S>) {
        std::size_t count = 0;
        for (const scene::Object& object : objects)
          count +=
              object.shape.kind == scene::kind_of<S> && object.transform == scene::no_transform && object.is_visible;
        if (std::is_same_v<S, scene::Plane>) return; // it is unbounded
        builder_->reserve<ShapeLeaves<Baked<GeometryOf<S>>>>(count);
      }
    });
  }

  CompiledObjects& compiled_;
  const bvh::Device& device_;
  MaterialBindings& bindings_;
  const scene::Scene& scene_;
  std::span<const scene::Object> objects_;
  std::span<const Part> parts_;
  HitRules rules_;
  Instancing instancing_;
  CsgBuilder csg_builder_;
  std::vector<const Aggregate*> group_aggregates_; // by group
  std::vector<const CsgSolid*> shared_solids_;     // by combination

  AggregateBuilder* builder_ = nullptr; // of the aggregate being built
  std::size_t next_part_ = 0;
};

} // namespace

std::shared_ptr<const CompiledObjects> compile(const scene::Scene& scene, std::span<const scene::Object> objects,
                                               const bvh::Device& device, MaterialBindings& bindings,
                                               std::span<const Part> parts,
                                               std::vector<std::shared_ptr<const CompiledObjects>> ready,
                                               HitRules rules) {
  const auto compiled = std::make_shared<CompiledObjects>();
  compiled->parts = std::move(ready);
  Compiler(*compiled, scene, objects, device, bindings, parts, rules).run();
  return compiled;
}

std::shared_ptr<const CompiledObjects> CompileCache::compile(const scene::Scene& scene, std::span<const Part> parts) {
  require_none(validate_settings(scene));
  std::vector<std::span<const scene::Object>> fresh = outside_of(parts, scene.objects);
  for (const Part& part : parts)
    if (!knows(part)) fresh.push_back(std::span(scene.objects).subspan(part.begin, part.end - part.begin));
  require_none(validate(scene, fresh));
  begin(scene);
  std::vector<std::shared_ptr<const CompiledObjects>> ready;
  for (const Part& part : parts) ready.push_back(take(scene, part));
  mark_ = bindings_->mark();
  forget_unused();
  return rt::compile(scene, scene.objects, *device_, *bindings_, parts, std::move(ready));
}

bool CompileCache::knows(const Part& part) const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const CachedPart& cached) { return cached.stamp == part.stamp; });
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

std::shared_ptr<const CompiledObjects> CompileCache::take(const scene::Scene& scene, const Part& part) {
  const std::uint32_t size = part.end - part.begin;
  for (CachedPart& cached : parts_) {
    if (cached.stamp != part.stamp) continue;
    cached.last_use = uses_;
    ++counts_.parts_reused;
    counts_.objects_reused += size;
    return cached.compiled;
  }
  const auto made = rt::compile(scene, std::span(scene.objects).subspan(part.begin, size), *device_, *bindings_);
  ++counts_.parts_built;
  counts_.objects_built += size;
  parts_.push_back({part.stamp, uses_, made});
  return made;
}

void CompileCache::forget_unused() {
  std::erase_if(parts_, [this](const CachedPart& cached) { return cached.last_use + patience < uses_; });
}

} // namespace rt
