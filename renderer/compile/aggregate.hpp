#pragma once

#include "renderer/compile/leaves.hpp"
#include "renderer/compile/sphere_leaves.hpp"

#include <array>
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

/// The leaves of an assembly by kind.
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

/// What is placed as one: the scene itself, or a group that stands in it more than once. It holds leaves, numbered by
/// slots in the order of declaration; an instance takes one slot here, but as many places in the scene's order as there
/// are leaves in it.
class Aggregate {
public:
  Aggregate() = default;
  Aggregate(const Aggregate&) = delete; // queries point to it
  Aggregate& operator=(const Aggregate&) = delete;

  /// Shows the query to what it may hit.
  void nearest(NearestQuery& query) const;
  bool blocks(ShadowQuery& query) const;
  /// The same for up to `bvh::packet_size` queries with rays that run close together. They all point to queries of
  /// these types.
  void nearest(std::span<bvh::Query* const> queries) const;
  std::array<bool, bvh::packet_size> blocks(std::span<bvh::Query* const> queries) const;

  /// The box around its leaves: empty maybe; infinite where they are.
  const Box3& box() const { return box_; }

  /// How many leaves come before the one in `slot`, all instances counted out.
  std::uint64_t order(std::uint32_t slot) const;
  std::uint64_t leaf_count() const { return leaf_count_; }

  /// An instance in the assembly.
  struct Step {
    const InstanceLeaves* leaves; ///< none where all of it is empty
    std::uint32_t index;
    std::uint32_t slot;
    std::uint64_t order; ///< of its first leaf
    std::uint64_t leaf_count;
  };
  /// The instance that holds the leaf of that order, or none: then it is one of the assembly's own, in slot `slot`.
  const Step* step_to(std::uint64_t order, std::uint32_t& slot) const;

  /// The positions that lead from the assembly to the object in a slot: in its list, in that one's members, and so on.
  std::vector<std::uint32_t> path(std::uint32_t slot) const;

private:
  friend class Compiler;

  // Slots that follow each other and come from objects of one list that follow each other.
  struct Run {
    std::uint32_t slot;
    std::uint32_t source;
    std::uint32_t position;
  };
  // A group whose members stand directly in the assembly: the parent's source and the position in its list.
  struct Source {
    std::uint32_t parent;
    std::uint32_t position;
  };

  // A leaf outside the tree: it has no finite box.
  struct Unbounded {
    const LeafKind* kind;
    const void* leaves;
    std::uint32_t index;
  };

  LeafSets bounded_, unbounded_;
  bvh::Tree tree_;                          // over the first
  std::vector<Unbounded> unbounded_leaves_; // the second
  Box3 box_;
  std::uint64_t leaf_count_ = 0;
  std::vector<Step> steps_; // by slot
  std::vector<Run> runs_;   // by slot
  std::vector<Source> sources_{{0, 0}};
};

} // namespace rt
