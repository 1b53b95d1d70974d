#pragma once

#include "renderer/math/box3.hpp"
#include "renderer/math/interval.hpp"
#include "renderer/math/ray.hpp"

#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

/// The acceleration structure: boxes in, a leaf callback out. It knows no shapes. Embree (3.13) builds and traverses
/// the tree in single precision; the callbacks get the ray in double precision and decide alone what is hit. Nothing
/// outside this folder knows Embree.
namespace rt::accel {

/// What trees are built with; it must outlive them.
class Device {
public:
  /// `threads` to build with, 0: one for each core. Throws std::runtime_error if Embree refuses.
  explicit Device(int threads);

private:
  friend class Tree;
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  };
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  bool has_packets_ = false;
};

/// A ray on its way through a tree. Callbacks receive it, as a type derived from it; they look for hits in its interval
/// and lower the interval's upper end when they take one, which leaves out what lies beyond. What lies at that end
/// exactly is still shown, so that callbacks can decide ties by a rule of their own.
class Query {
public:
  Query(const Ray& r, const Interval& i) : ray(r), interval(i), inverse_square(1 / dot(r.direction, r.direction)) {}

  Ray ray; ///< in the tree's space; t counts lengths of its direction, which need not be a unit vector
  Interval interval;
  double inverse_square; ///< 1 / |direction|²

private:
  friend class Tree;
  double start_ = 0; // Embree's t is scale_ · (t − start_)
  double scale_ = 1;
};

/// How many queries may travel together.
inline constexpr std::size_t packet_size = 16;

/// A tree over leaves of several kinds. A set of leaves of one kind has
///
///   std::uint32_t size() const;
///   Box3 bounds(std::uint32_t i) const;                   // finite, not empty
///   void nearest(std::uint32_t i, NearestQuery&) const;   // lowers interval.upper when it takes a hit
///   bool blocks(std::uint32_t i, ShadowQuery&) const;     // true ends the traversal
///
/// and becomes an Embree geometry of its own, so that its callback is one function without a switch over kinds.
class Tree {
public:
  Tree() = default;

  /// For leaves inside `bounds`, the union of their boxes (finite, not empty), which fixes how boxes and rays are
  /// brought to single precision. `add` the sets, then `build`.
  Tree(const Device& device, const Box3& bounds);

  /// `leaves` must stay where it is as long as the tree is used. An empty set is left out.
  template <class NearestQuery, class ShadowQuery, class Leaves>
  void add(const Leaves& leaves) {
    if (leaves.size() == 0) return;
    add({&leaves, leaves.size(), &box_of<Leaves>}, &on_nearest<Leaves, NearestQuery>, &on_blocks<Leaves, ShadowQuery>);
  }

  /// Throws std::bad_alloc or std::runtime_error.
  void build();

  bool is_empty() const { return !scene_; }
  const Box3& bounds() const { return bounds_; }

  /// Shows `query` to the `nearest` callbacks of the leaves in its way, about from near to far. `query` must be of the
  /// types that the sets were added with.
  void nearest(Query& query) const;
  /// Shows it to `blocks`, in no particular order; true if one of them returned true.
  bool blocks(Query& query) const;

  /// The same for up to `packet_size` queries with rays that run close together: each is shown the same leaves, and
  /// what the callbacks decide does not depend on its company.
  void nearest(std::span<Query* const> queries) const;
  /// One answer for each query.
  std::array<bool, packet_size> blocks(std::span<Query* const> queries) const;

private:
  struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  // A set of leaves, its type forgotten, for the time of building.
  struct Set {
    const void* leaves;
    std::uint32_t size;
    Box3 (*bounds)(const void* leaves, std::uint32_t i);
    const Tree* tree = nullptr;
    RTCGeometry geometry = nullptr;
  };
  // What Embree hands through to the callbacks: its own context, and the way back to the queries, which the rays' ids
  // count.
  struct Context {
    RTCIntersectContext embree;
    Query* const* queries;
    explicit Context(Query* const* all) : queries(all) { rtcInitIntersectContext(&embree); }
  };

  void add(const Set& set, RTCIntersectFunctionN when_nearest, RTCOccludedFunctionN when_blocks);
  struct TreeRay; // a ray as it enters, in single precision
  bool enter(Query& query, TreeRay& entry) const;
  static void fill(const TreeRay& entry, RTCRay& ray);
  template <class Rays>
  void enter_all(std::span<Query* const> queries, Rays& rays, int* are_valid) const;
  RTCBounds to_single(const Box3& box) const;
  static void on_bounds(const RTCBoundsFunctionArguments* args);

  template <class Leaves>
  static Box3 box_of(const void* leaves, std::uint32_t i) {
    return static_cast<const Leaves*>(leaves)->bounds(i);
  }
  template <class Leaves, class NearestQuery>
  static void on_nearest(const RTCIntersectFunctionNArguments* args) {
    const auto& leaves = *static_cast<const Leaves*>(args->geometryUserPtr);
    Query* const* queries = reinterpret_cast<Context*>(args->context)->queries;
    const auto show = [&](Query& query, float& tfar) {
      const double before = query.interval.upper;
      leaves.nearest(args->primID, static_cast<NearestQuery&>(query));
      if (query.interval.upper < before) tfar = single_t(query);
    };
    if (args->N == 1) {
      RTCRay& ray = reinterpret_cast<RTCRayHit*>(args->rayhit)->ray;
      return show(*queries[ray.id], ray.tfar);
    }
    RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
    for (unsigned lane = 0; lane < args->N; ++lane)
      if (args->valid[lane] != 0) show(*queries[RTCRayN_id(rays, args->N, lane)], RTCRayN_tfar(rays, args->N, lane));
  }
  template <class Leaves, class ShadowQuery>
  static void on_blocks(const RTCOccludedFunctionNArguments* args) {
    const auto& leaves = *static_cast<const Leaves*>(args->geometryUserPtr);
    Query* const* queries = reinterpret_cast<Context*>(args->context)->queries;
    const auto show = [&](Query& query, float& tfar) {
      if (leaves.blocks(args->primID, static_cast<ShadowQuery&>(query))) tfar = -std::numeric_limits<float>::infinity();
    };
    if (args->N == 1) {
      RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
      return show(*queries[ray.id], ray.tfar);
    }
    for (unsigned lane = 0; lane < args->N; ++lane)
      if (args->valid[lane] != 0)
        show(*queries[RTCRayN_id(args->ray, args->N, lane)], RTCRayN_tfar(args->ray, args->N, lane));
  }
  // The end of the interval rounded up, so that Embree does not cull what lies there or before.
  static float single_t(const Query& query) {
    const double t = (query.interval.upper - query.start_) * query.scale_ * (1 + 0x1p-22);
    return t < std::numeric_limits<float>::max() ? static_cast<float>(t) : std::numeric_limits<float>::infinity();
  }

  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
  const Device* device_ = nullptr;
  std::vector<Set> sets_; // until built
  Box3 bounds_;
  Vec3 center_;      // of the bounds; subtracted in double, so that a scene far from the origin loses nothing
  double scale_ = 1; // a power of two that brings the bounds to about unit size
};

} // namespace rt::accel
