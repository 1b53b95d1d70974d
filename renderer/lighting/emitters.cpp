#include "renderer/lighting/emitters.hpp"

#include "renderer/compile/aggregate.hpp"
#include "renderer/math/hashing.hpp"
#include "renderer/sampling/sobol.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace rt {

/// Traverses the compiled scene. Aggregates without a lamp are skipped, however often they are placed.
class Emitters::Search {
public:
  Search(Emitters& emitters, const MaterialBindings& bindings) : emitters_(emitters), bindings_(bindings) {}

  /// The material that objects without one inherit, and the space of its patterns.
  struct Place {
    Affine to_scene;
    BindingId inherited;
    std::uint64_t base;
  };

  void visit(const Aggregate& aggregate, const Place& place) {
    aggregate.for_each_set([&]<class Leaves>(const Leaves& leaves) {
      if constexpr (std::is_same_v<Leaves, InstanceLeaves>)
        visit_instances(leaves, place);
      else if constexpr (std::is_same_v<Leaves, SolidLeaves>)
        visit_solids(aggregate, leaves, place);
      else
        visit_shapes(aggregate, leaves, place);
    });
  }

private:
  BindingId resolved(BindingId binding, const Place& place) const {
    return binding == inherited_binding ? place.inherited : binding;
  }

  bool has_lamps(const Aggregate& aggregate, BindingId inherited) {
    const auto [known, is_new] = has_lamps_.try_emplace({&aggregate, bindings_.shines(inherited)}, false);
    if (is_new) {
      bool found = false;
      const Place place{{}, inherited, 0};
      aggregate.for_each_set([&]<class Leaves>(const Leaves& leaves) {
        if constexpr (std::is_same_v<Leaves, InstanceLeaves>) {
          for (std::uint32_t i = 0; i < leaves.size() && !found; ++i)
            found = has_lamps(*leaves.instance(i).aggregate, resolved(leaves.tag(i).binding_id(), place));
        } else if constexpr (std::is_same_v<Leaves, SolidLeaves>) {
          found = found || leaves.size() > 0; // they are few
        } else {
          for (std::uint32_t i = 0; i < leaves.shape_count() && !found; ++i)
            found = bindings_.shines(resolved(leaves.tag(i).binding_id(), place));
        }
      });
      known->second = found;
    }
    return known->second;
  }

  void visit_instances(const InstanceLeaves& leaves, const Place& place) {
    for (std::uint32_t i = 0; i < leaves.size(); ++i) {
      const LeafTag tag = leaves.tag(i);
      const InstanceLeaves::Instance& instance = leaves.instance(i);
      const BindingId inherited = resolved(tag.binding_id(), place);
      if (!tag.casts_shadow || !has_lamps(*instance.aggregate, inherited)) continue;
      const Affine map = instance.part_begin ? place.to_scene : place.to_scene * instance.to_outer;
      visit(*instance.aggregate, {map, inherited, place.base + instance.order});
    }
  }

  template <class Leaves>
  void visit_shapes(const Aggregate& aggregate, const Leaves& leaves, const Place& place) {
    for (std::uint32_t i = 0; i < leaves.shape_count(); ++i) {
      const LeafTag tag = leaves.tag(i);
      if (!tag.casts_shadow || !bindings_.shines(resolved(tag.binding_id(), place))) continue;
      add(leaves.shape(i), place.to_scene, resolved(tag.binding_id(), place), {&leaves, place.base, i, 0},
          place.base + aggregate.order(tag.slot));
    }
  }

  // By the surfaces of the operands. Samples on parts that are no surface of the solid are wasted.
  void visit_solids(const Aggregate& aggregate, const SolidLeaves& leaves, const Place& place) {
    for (std::uint32_t i = 0; i < leaves.size(); ++i) {
      const LeafTag tag = leaves.tag(i);
      const SolidLeaves::PlacedSolid& solid = leaves.placed(i);
      const Affine map = solid.is_in_place ? place.to_scene : place.to_scene * solid.to_outer;
      for (std::uint32_t j = 0; j < solid.solid->operand_count() && tag.casts_shadow; ++j) {
        const CsgSolid::Operand& operand = solid.solid->operand(j);
        const BindingId binding =
            operand.binding == inherited_binding ? resolved(tag.binding_id(), place) : operand.binding;
        if (!operand.casts_shadow || !bindings_.shines(binding)) continue;
        std::visit(
            [&](const auto& shape) {
              add(shape, map, binding, {&leaves, place.base, i, j}, place.base + aggregate.order(tag.slot));
            },
            operand.shape);
      }
    }
  }

  template <class G>
  void add(const Baked<G>& shape, const Affine& map, BindingId binding, const Identity& identity, std::uint64_t order) {
    add_surface(shape.shape, map, binding, identity, order);
  }
  template <class G>
  void add(const Transformed<G>& shape, const Affine& map, BindingId binding, const Identity& identity,
           std::uint64_t order) {
    add_surface(shape.shape, map * shape.to_outer, binding, identity, order);
  }

  template <class G>
  void add_surface(const G& shape, const Affine& map, BindingId binding, const Identity& identity,
                   std::uint64_t order) {
    if constexpr (Drawable<G>) {
      if (const auto emitter = Emitter::make(lamp_surface(shape), map))
        emitters_.list_.push_back({*emitter, identity, order, radiance(binding) * emitter->surface_area()});
    }
  }

  // Roughly how much light a lamp of this material emits. A pattern is evaluated at a few points: whatever they give,
  // the lamp is sampled often enough.
  double radiance(BindingId binding) const {
    MaterialValues scratch;
    double sum = 0;
    constexpr std::uint32_t places = 16;
    for (std::uint32_t i = 0; i < places; ++i) {
      const auto at = SampleStream(0, 0, 0, i).group(0);
      const MaterialValues& v = bindings_.values(bindings_.material(binding), {at[0], at[1], at[2]}, scratch);
      sum += max_component(v.color * v.emission) * (1 - v.refract) / places;
    }
    return std::max(sum, 1e-3);
  }

  Emitters& emitters_;
  const MaterialBindings& bindings_;
  std::map<std::pair<const Aggregate*, bool>, bool> has_lamps_;
};

Emitters::Emitters(const CompiledScene& scene) {
  const MaterialBindings& bindings = scene.bindings();
  if (!bindings.any_shines()) return;
  Search(*this, bindings).visit(scene.objects(), {{}, bindings.default_binding(), 0});
  // Independent of how the scene was compiled.
  std::stable_sort(list_.begin(), list_.end(), [](const ListedEmitter& a, const ListedEmitter& b) {
    return std::tie(a.order, a.identity.operand) < std::tie(b.order, b.identity.operand);
  });
  std::vector<LightBounds> bounds;
  for (const ListedEmitter& entry : list_) {
    by_identity_.emplace(entry.identity, static_cast<std::uint32_t>(bounds.size()));
    bounds.push_back(entry.emitter.bounds(entry.power));
  }
  tree_ = LightTree(bounds);
}

std::size_t Emitters::IdentityHash::operator()(const Identity& identity) const {
  return Hasher()
      .add(reinterpret_cast<std::uintptr_t>(identity.leaves))
      .add(identity.base)
      .add(std::uint64_t{identity.index} << 32 | identity.operand)
      .value();
}

std::optional<std::uint32_t> Emitters::find(const RayHit& hit) const {
  const auto found = by_identity_.find({hit.leaves, hit.base, hit.index, hit.operand});
  return found == by_identity_.end() ? std::nullopt : std::optional(found->second);
}

} // namespace rt
