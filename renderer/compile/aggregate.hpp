#pragma once

#include "renderer/compile/leaves/leaves.hpp"
#include "renderer/compile/leaves/sphere_leaves.hpp"
#include "renderer/scene/validation/validate.hpp"

#include <array>
#include <memory>
#include <span>
#include <tuple>
#include <vector>

namespace rt {

namespace detail {
template <class Tuple>
struct LeafSetsOf;
template <class... G>
struct LeafSetsOf<std::tuple<G...>> {
  using Type = std::tuple<ShapeLeaves<Baked<G>>..., ShapeLeaves<Transformed<G>>..., SolidLeaves, InstanceLeaves>;
};
} // namespace detail

/// The leaves of an aggregate by kind.
class LeafSets {
public:
  template <class Leaves>
  Leaves& all() {
    return std::get<Leaves>(sets_);
  }
  template <class Leaves>
  const Leaves& all() const {
    return std::get<Leaves>(sets_);
  }
  template <class F>
  void for_each(F&& f) {
    std::apply([&](auto&... set) { (f(set), ...); }, sets_);
  }
  template <class F>
  void for_each(F&& f) const {
    std::apply([&](const auto&... set) { (f(set), ...); }, sets_);
  }

private:
  detail::LeafSetsOf<Geometries>::Type sets_;
};

/// What is placed as a unit: the scene itself, or a group that occurs in it more than once. It holds objects, numbered
/// by slots in the order of declaration, each with any number of leaves. An instance of another aggregate takes one
/// slot here, but counts in the scene's order as many times as there are objects in it.
class Aggregate {
public:
  Aggregate() = default;
  Aggregate(const Aggregate&) = delete; // queries point to it
  Aggregate& operator=(const Aggregate&) = delete;

  /// Finds the nearest hit, if it is nearer than the query's.
  void nearest(NearestQuery& query) const;
  bool blocks(ShadowQuery& query) const;
  /// The same for up to `bvh::packet_size` queries with coherent rays. The pointers must be to queries of these
  /// types.
  void nearest(std::span<bvh::Query* const> queries) const;
  std::array<bool, bvh::packet_size> blocks(std::span<bvh::Query* const> queries) const;

  /// The bounding box of its leaves: possibly empty; infinite where they are.
  const Box3& box() const { return box_; }
  /// The greatest distance of its finite parts from the origin, as a sum of coordinates: it scales rounding errors.
  double reach() const { return reach_; }

  /// Calls f with each set of its leaves.
  template <class F>
  void for_each_set(F&& f) const {
    bounded_.for_each(f);
    unbounded_.for_each(f);
  }

  /// How many objects precede the one in `slot`, counting those within instances one by one.
  std::uint64_t order(std::uint32_t slot) const;
  std::uint64_t object_count() const { return object_count_; }

  /// An instance in the aggregate.
  struct Step {
    const InstanceLeaves* leaves; ///< null if it contains nothing at all
    std::uint32_t index;
    std::uint32_t slot;
    std::uint64_t order; ///< of its first object
    std::uint64_t object_count;
  };
  /// The instance that contains the object of that order; null if that is one of the aggregate's own, in slot `slot`.
  const Step* step_to(std::uint64_t order, std::uint32_t& slot) const;

  /// The indices that lead from the aggregate to the object in a slot: into its list, then its members', and so on.
  std::vector<std::uint32_t> path(std::uint32_t slot) const;

private:
  friend class AggregateBuilder;

  // Consecutive slots of consecutive objects of one list.
  struct Run {
    std::uint32_t slot;
    std::uint32_t source;
    std::uint32_t position;
  };
  // A group whose members are directly in the aggregate: the parent's source and the index in its list.
  struct Source {
    std::uint32_t parent;
    std::uint32_t position;
  };

  // A leaf outside the tree: it has no finite box, or there are too few for a tree.
  struct LooseLeaf {
    const LeafKind* kind;
    const void* leaves;
    std::uint32_t index;
  };

  LeafSets bounded_, unbounded_;
  bvh::Tree tree_; // over the former, unless they are loose as well
  std::vector<LooseLeaf> loose_leaves_;
  Box3 box_;
  double reach_ = 0;
  std::uint64_t object_count_ = 0;
  std::vector<Step> steps_; // by slot
  std::vector<Run> runs_;   // by slot
  std::vector<Source> sources_{{0, 0}};
};

/// Builds an aggregate, object by object in the order of declaration.
class AggregateBuilder {
public:
  explicit AggregateBuilder(Aggregate& aggregate) : aggregate_(aggregate) {}

  /// A group whose members become objects of the aggregate: the source of their list. The aggregate's own list is
  /// source 0.
  std::uint32_t add_source(std::uint32_t parent, std::uint32_t position);
  /// The next object, of the list `source`; returns its slot. All its leaves, however many, are tagged with it.
  std::uint32_t add_object(std::uint32_t source, std::uint32_t position);

  /// A leaf whose geometry is placed in the aggregate by `map`, which is invertible.
  template <class G>
  void add_shape(const G& own, const Affine& map, LeafTag tag) {
    if (std::optional<G> here = placed(own, map))
      add_leaf<ShapeLeaves<Baked<G>>>(Baked<G>{std::move(*here)}, tag);
    else
      add_leaf<ShapeLeaves<Transformed<G>>>(Transformed<G>{own, map, scene::inverse_of_nested(map)}, tag);
  }
  void add_solid(const SolidLeaves::PlacedSolid& solid, LeafTag tag);
  void add_instance(const Aggregate& aggregate, const Affine& map, LeafTag tag);
  /// A part of the scene's list that was compiled separately and starts at `begin`.
  void add_part(const Aggregate& aggregate, std::uint32_t begin, LeafTag tag);

  /// Reserves room for that many leaves of the kind, so that the arrays of a large scene do not grow by doubling.
  template <class Leaves>
  void reserve(std::size_t count) {
    aggregate_.bounded_.all<Leaves>().reserve(count);
  }

  /// After the last object. Throws std::bad_alloc or std::runtime_error.
  void build(const bvh::Device& device);

private:
  template <class Leaves, class Placed>
  void add_leaf(Placed shape, LeafTag tag) {
    const Box3 box = shape.box();
    if (!box.is_empty()) sets_for(box).template all<Leaves>().add(std::move(shape), tag);
  }
  LeafSets& sets_for(const Box3& box);
  void add_instance(const InstanceLeaves::Instance& instance, const Box3& box, LeafTag tag);
  void add_loose(const LeafSets& sets);

  Aggregate& aggregate_;
  std::uint32_t slot_count_ = 0;
};

/// Objects of a scene compiled to aggregates: all of them, or a part of the scene's list.
struct CompiledObjects {
  std::vector<std::shared_ptr<const CompiledObjects>> parts;
  std::vector<std::unique_ptr<CsgSolid>> solids;
  std::vector<std::unique_ptr<Aggregate>> aggregates; ///< each one after those it has instances of

  const Aggregate& root() const { return *aggregates.back(); }
};

} // namespace rt
