#pragma once

#include "renderer/bvh/bvh.hpp"

#include <embree3/rtcore.h>

#include <type_traits>

namespace rt::bvh {

class EmbreeDevice {
public:
  /// `threads` to build with; 0: one per core. Throws std::runtime_error if Embree fails to initialise.
  explicit EmbreeDevice(int threads);

  RTCDevice get() const { return device_.get(); }
  bool has_packets() const { return has_packets_; }

private:
  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  };
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release> device_;
  bool has_packets_ = false;
};

/// A tree that Embree (3.13) builds and traverses in single precision. Each set of leaves is a separate geometry.
class EmbreeTree {
public:
  EmbreeTree(const EmbreeDevice& device, const Box3& bounds);
  EmbreeTree(const EmbreeTree&) = delete; // Embree points to the geometries
  EmbreeTree& operator=(const EmbreeTree&) = delete;

  /// Throws std::bad_alloc or std::runtime_error.
  void build(std::vector<LeafSet> sets);

  void nearest(Query& query) const;
  bool blocks(Query& query) const;
  void nearest(std::span<Query* const> queries) const;
  std::array<bool, packet_size> blocks(std::span<Query* const> queries) const;

private:
  struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  // What Embree passes through to the callbacks: its own context, and the queries, which the rays' ids
  // index.
  struct Context {
    RTCIntersectContext embree;
    Query* const* queries;
    explicit Context(Query* const* all) : queries(all) { rtcInitIntersectContext(&embree); }
  };

  struct Geometry : LeafSet {
    const EmbreeTree* tree;
  };

  struct SingleRay; // a ray as Embree takes it, in single precision
  bool enter(Query& query, SingleRay& single) const;
  static void fill(const SingleRay& single, RTCRay& ray);
  template <class Rays>
  void enter_all(std::span<Query* const> queries, Rays& rays, int* are_valid) const;
  RTCBounds to_single(const Box3& box) const;
  static float single_t(const Query& query);

  static void on_bounds(const RTCBoundsFunctionArguments* args);
  static void on_nearest(const RTCIntersectFunctionNArguments* args);
  static void on_blocks(const RTCOccludedFunctionNArguments* args);

  std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
  const EmbreeDevice* device_;
  std::vector<Geometry> geometries_;
  Box3 bounds_;
  Vec3 center_;      // of the bounds; subtracted in double, so that a scene far from the origin loses no precision
  double scale_ = 1; // a power of two that scales the bounds to about unit size
};

} // namespace rt::bvh
