#pragma once

#include "renderer/math/box3.hpp"
#include "renderer/math/interval.hpp"
#include "renderer/math/ray.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

/// The bounding volume hierarchy: boxes in, leaf callbacks out. It knows nothing of shapes. Two implementations share
/// one interface and must give the same answers: Embree's, and a plain one of our own that needs no other library.
/// Either may work in less than double precision but never misses a leaf; the callbacks get the ray as given and alone
/// decide what is hit.
namespace rt::bvh {

/// Which implementation builds and traverses the trees.
enum class Builder { embree, portable };
/// The CMake option RTLANG_BVH.
extern const Builder default_builder;

class EmbreeDevice;
class EmbreeTree;
class PortableTree;

/// What trees are built with; it must outlive them.
class Device {
public:
  /// `threads` to build with; 0: one per core. Throws std::runtime_error if Embree fails to initialise.
  explicit Device(int threads, Builder builder = default_builder);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

private:
  friend class Tree;
  std::unique_ptr<EmbreeDevice> embree_; // null: the portable builder needs nothing
};

/// A ray traversing a tree. Callbacks receive it as a type derived from it; they look for hits in its interval and
/// lower the interval's upper end when they accept one, which culls what lies beyond. Leaves at exactly that distance
/// are still visited, so that callbacks can break ties by a rule of their own.
class Query {
public:
  Query(const Ray& r, const Interval& i) : ray(r), interval(i), inverse_square(1 / dot(r.direction, r.direction)) {}

  Ray ray; ///< in the tree's space; t is in multiples of its direction, which need not be a unit vector
  Interval interval;
  double inverse_square; ///< 1 / |direction|²

private:
  friend class EmbreeTree;
  double start_ = 0; // Embree's t is scale_ · (t − start_)
  double scale_ = 1;
};

/// How many queries can be traced as one packet.
inline constexpr std::size_t packet_size = 16;

/// A subset of a packet's queries, one bit each.
using QueryMask = std::uint32_t;

/// A type-erased set of leaves: functions per kind of leaf instead of a switch over kinds, for a single query and for
/// those queries of a packet that reach the leaf.
struct LeafSet {
  const void* leaves;
  void (*nearest)(const void* leaves, std::uint32_t i, Query& query);
  bool (*blocks)(const void* leaves, std::uint32_t i, Query& query);
  /// Returns the queries whose intervals it shortens, and those that it blocks.
  QueryMask (*nearest_of)(const void* leaves, std::uint32_t i, Query* const* queries, QueryMask which);
  QueryMask (*blocks_of)(const void* leaves, std::uint32_t i, Query* const* queries, QueryMask which);
  Box3 (*bounds)(const void* leaves, std::uint32_t i);
  std::uint32_t size;
};

/// A tree over leaves of several kinds. A set of leaves of one kind must provide
///
///   std::uint32_t size() const;
///   Box3 bounds(std::uint32_t i) const;                   // finite, not empty
///   void nearest(std::uint32_t i, NearestQuery&) const;   // lowers interval.upper when it accepts a hit
///   bool blocks(std::uint32_t i, ShadowQuery&) const;     // true ends the traversal
class Tree {
public:
  Tree();
  /// For leaves inside `bounds`, the union of their boxes (finite, not empty), which determines how boxes and rays are
  /// rounded. `add` the sets, then `build`.
  Tree(const Device& device, const Box3& bounds);
  ~Tree();
  Tree(Tree&&) noexcept;
  Tree& operator=(Tree&&) noexcept;

  /// `leaves` must stay where it is as long as the tree is used. An empty set is ignored.
  template <class NearestQuery, class ShadowQuery, class Leaves>
  void add(const Leaves& leaves) {
    if (leaves.size() == 0) return;
    sets_.push_back({&leaves,
                     [](const void* all, std::uint32_t i, Query& query) {
                       static_cast<const Leaves*>(all)->nearest(i, static_cast<NearestQuery&>(query));
                     },
                     [](const void* all, std::uint32_t i, Query& query) {
                       return static_cast<const Leaves*>(all)->blocks(i, static_cast<ShadowQuery&>(query));
                     },
                     [](const void* all, std::uint32_t i, Query* const* queries, QueryMask which) {
                       const auto& set = *static_cast<const Leaves*>(all);
                       QueryMask shortened = 0;
                       for (; which != 0; which &= which - 1) {
                         auto& query = static_cast<NearestQuery&>(*queries[std::countr_zero(which)]);
                         const double before = query.interval.upper;
                         set.nearest(i, query);
                         if (query.interval.upper < before) shortened |= which & -which;
                       }
                       return shortened;
                     },
                     [](const void* all, std::uint32_t i, Query* const* queries, QueryMask which) {
                       const auto& set = *static_cast<const Leaves*>(all);
                       QueryMask blocked = 0;
                       for (; which != 0; which &= which - 1)
                         if (set.blocks(i, static_cast<ShadowQuery&>(*queries[std::countr_zero(which)])))
                           blocked |= which & -which;
                       return blocked;
                     },
                     [](const void* all, std::uint32_t i) { return static_cast<const Leaves*>(all)->bounds(i); },
                     leaves.size()});
  }

  /// Throws std::bad_alloc or std::runtime_error.
  void build();

  bool is_empty() const { return !embree_ && !portable_; }

  /// Calls `nearest` with `query` for the leaves along its ray, roughly front to back. `query` must be of the types
  /// that the sets were added with.
  void nearest(Query& query) const;
  /// Calls `blocks`, in no particular order; true if one of the calls returned true.
  bool blocks(Query& query) const;

  /// The same for up to `packet_size` queries with coherent rays: each visits the same leaves as on its own, and what
  /// the callbacks decide for one does not depend on the others.
  void nearest(std::span<Query* const> queries) const;
  /// One answer for each query.
  std::array<bool, packet_size> blocks(std::span<Query* const> queries) const;

private:
  std::vector<LeafSet> sets_; // until built
  std::unique_ptr<EmbreeTree> embree_;
  std::unique_ptr<PortableTree> portable_;
};

} // namespace rt::bvh
