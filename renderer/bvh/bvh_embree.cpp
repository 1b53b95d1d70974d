#include "renderer/bvh/bvh_embree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace rt::bvh {
namespace {

constexpr float single_infinity = std::numeric_limits<float>::infinity();

// In scaled space the whole scene lies within ±1. A ray starts within ±4, where it is advanced to if need be, and
// travels at most 5√3 there. In single precision (ε = 2⁻²⁴) its origin moves by 2ε along each axis and its direction
// turns by ε. Embree's traversal (the fast one for user geometries, whatever the scene's flags) computes each slab's t
// to within 5ε of t, and compares those of two axes: an error of 2ε + (1 + 2 · 5) · 5√3 ε < 98ε in all. 128ε leaves
// room for t's own rounding.
constexpr double reach = 4, padding = 0x1p-17;

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE) throw std::runtime_error("Embree failed with error " + std::to_string(error));
}

float round_down(double value) {
  const auto single = static_cast<float>(value);
  return std::nextafter(single, -single_infinity);
}

float round_up(double value) {
  const auto single = static_cast<float>(value);
  return std::nextafter(single, single_infinity);
}

// RTLANG_EMBREE adds Embree's own settings: `isa=avx2` lets tests and measurements see what other processors do.
std::string settings(int threads) {
  std::string all = "set_affinity=0,threads=" + std::to_string(std::max(threads, 0));
  if (const char* const more = std::getenv("RTLANG_EMBREE")) all.append(",").append(more);
  return all;
}

// Whether the ray hits the box within its interval; if so, `start` is where it enters or already is inside.
bool meets(const Query& query, const Box3& box, double& start) {
  double from = query.interval.lower, to = query.interval.upper;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double o = query.ray.origin[axis], d = query.ray.direction[axis];
    if (d == 0) {
      if (o < box.lower[axis] || o > box.upper[axis]) return false;
      continue;
    }
    const double inverse = 1 / d, a = (box.lower[axis] - o) * inverse, b = (box.upper[axis] - o) * inverse;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  start = from;
  return from <= to;
}

// For a packet, whose lanes are its queries.
QueryMask queries_of(const int* are_valid) {
  QueryMask mask = 0;
  for (unsigned lane = 0; lane < packet_size; ++lane) mask |= (static_cast<QueryMask>(are_valid[lane]) & 1) << lane;
  return mask;
}

} // namespace

EmbreeDevice::EmbreeDevice(int threads) : device_(rtcNewDevice(settings(threads).c_str())) {
  if (!device_)
    throw std::runtime_error("Embree cannot be started: error " + std::to_string(rtcGetDeviceError(nullptr)));
  has_packets_ = rtcGetDeviceProperty(device_.get(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0;
}

EmbreeTree::EmbreeTree(const EmbreeDevice& device, const Box3& bounds)
    : scene_(rtcNewScene(device.get())), device_(&device), center_(bounds.center()) {
  check(device.get());
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);

  const double extent = max_component(bounds.extent()) * 0.5;
  scale_ = extent > 0 ? std::exp2(-std::ceil(std::log2(extent))) : 1;
  // A ray is advanced to these bounds: slightly wider than the leaves', so that its rounding misses none of them.
  const double margin = padding / scale_ + 0x1p-50 * max_component(abs(center_));
  bounds_ = {bounds.lower - Vec3{margin, margin, margin}, bounds.upper + Vec3{margin, margin, margin}};
}

void EmbreeTree::build(std::vector<LeafSet> sets) {
  geometries_.reserve(sets.size());
  for (const LeafSet& set : sets) {
    geometries_.push_back({set, this});
    RTCGeometry geometry = rtcNewGeometry(device_->get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, set.size);
    rtcSetGeometryUserData(geometry, &geometries_.back());
    rtcSetGeometryBoundsFunction(geometry, &on_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, &on_nearest);
    rtcSetGeometryOccludedFunction(geometry, &on_blocks);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry); // the scene keeps it
  }
  rtcCommitScene(scene_.get());
  check(device_->get());
}

void EmbreeTree::on_bounds(const RTCBoundsFunctionArguments* args) {
  const Geometry& geometry = *static_cast<const Geometry*>(args->geometryUserPtr);
  *args->bounds_o = geometry.tree->to_single(geometry.bounds(geometry.leaves, args->primID));
}

RTCBounds EmbreeTree::to_single(const Box3& box) const {
  const Vec3 pad{padding, padding, padding};
  const Vec3 lower = (box.lower - center_) * scale_ - pad, upper = (box.upper - center_) * scale_ + pad;
  return {round_down(lower.x), round_down(lower.y), round_down(lower.z), 0,
          round_up(upper.x),   round_up(upper.y),   round_up(upper.z),   0};
}

// The end of the interval rounded up, so that Embree does not cull what lies there or before.
inline float EmbreeTree::single_t(const Query& query) {
  const double t = (query.interval.upper - query.start_) * query.scale_ * (1 + 0x1p-22);
  return t < std::numeric_limits<float>::max() ? static_cast<float>(t) : single_infinity;
}

// From Embree's lanes to the leaf's own function, which knows nothing of them. A ray's id is its query's index; a
// packet arrives as it was sent, in sixteen lanes.
void EmbreeTree::on_nearest(const RTCIntersectFunctionNArguments* args) {
  const Geometry& set = *static_cast<const Geometry*>(args->geometryUserPtr);
  Query* const* queries = reinterpret_cast<Context*>(args->context)->queries;
  if (args->N == 1) {
    RTCRay& ray = reinterpret_cast<RTCRayHit*>(args->rayhit)->ray;
    Query& query = *queries[ray.id];
    const double before = query.interval.upper;
    set.nearest(set.leaves, args->primID, query);
    if (query.interval.upper < before) ray.tfar = single_t(query);
    return;
  }
  RTCRay16& rays = reinterpret_cast<RTCRayHit16*>(args->rayhit)->ray;
  QueryMask shortened = set.nearest_of(set.leaves, args->primID, queries, queries_of(args->valid));
  for (; shortened != 0; shortened &= shortened - 1) {
    const int lane = std::countr_zero(shortened);
    rays.tfar[lane] = single_t(*queries[lane]);
  }
}

void EmbreeTree::on_blocks(const RTCOccludedFunctionNArguments* args) {
  const Geometry& set = *static_cast<const Geometry*>(args->geometryUserPtr);
  Query* const* queries = reinterpret_cast<Context*>(args->context)->queries;
  if (args->N == 1) {
    RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
    if (set.blocks(set.leaves, args->primID, *queries[ray.id])) ray.tfar = -single_infinity;
    return;
  }
  RTCRay16& rays = *reinterpret_cast<RTCRay16*>(args->ray);
  QueryMask blocked = set.blocks_of(set.leaves, args->primID, queries, queries_of(args->valid));
  for (; blocked != 0; blocked &= blocked - 1) rays.tfar[std::countr_zero(blocked)] = -single_infinity;
}

struct EmbreeTree::SingleRay {
  float origin[3], direction[3], tfar;
};

inline bool EmbreeTree::enter(Query& query, SingleRay& single) const {
  Vec3 origin = (query.ray.origin - center_) * scale_, direction = query.ray.direction;
  query.start_ = 0;
  query.scale_ = scale_;
  if (query.interval.lower < 0 || !(max_component(abs(origin)) <= reach)) {
    if (!meets(query, bounds_, query.start_)) return false;
    origin = (query.ray.at(query.start_) - center_) * scale_;
  }
  // Its length does not matter as long as it is roughly a unit vector, as most are.
  if (!(query.inverse_square > 0.25 && query.inverse_square < 4)) {
    const double speed = std::sqrt(dot(direction, direction));
    direction = direction * (1 / speed);
    query.scale_ = speed * scale_;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    single.origin[axis] = static_cast<float>(origin[axis]);
    single.direction[axis] = static_cast<float>(direction[axis]);
  }
  single.tfar = single_t(query);
  return true;
}

// Embree loads four numbers at a time, soon after: storing them the same way allows store forwarding.
inline void EmbreeTree::fill(const SingleRay& single, RTCRay& ray) {
  using Four = float __attribute__((vector_size(16)));
  const Four origin{single.origin[0], single.origin[1], single.origin[2], 0};
  const Four direction{single.direction[0], single.direction[1], single.direction[2], 0};
  std::memcpy(&ray.org_x, &origin, sizeof origin);    // and tnear
  std::memcpy(&ray.dir_x, &direction, sizeof origin); // and time
  ray.tfar = single.tfar;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
}

void EmbreeTree::nearest(Query& query) const {
  SingleRay single;
  if (!enter(query, single)) return;
  RTCRayHit hit;
  fill(single, hit.ray);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Query* const queries = &query;
  Context context(&queries);
  rtcIntersect1(scene_.get(), &context.embree, &hit);
}

bool EmbreeTree::blocks(Query& query) const {
  SingleRay single;
  if (!enter(query, single)) return false;
  RTCRay ray;
  fill(single, ray);
  Query* const queries = &query;
  Context context(&queries);
  rtcOccluded1(scene_.get(), &context.embree, &ray);
  return ray.tfar < 0;
}

// Sets up the rays of a packet; those without a query, or whose query misses the bounds, are not valid.
template <class Rays>
void EmbreeTree::enter_all(std::span<Query* const> queries, Rays& rays, int* are_valid) const {
  for (std::size_t i = 0; i < packet_size; ++i) {
    SingleRay single{};
    are_valid[i] = i < queries.size() && enter(*queries[i], single) ? -1 : 0;
    rays.org_x[i] = single.origin[0];
    rays.org_y[i] = single.origin[1];
    rays.org_z[i] = single.origin[2];
    rays.tnear[i] = 0;
    rays.dir_x[i] = single.direction[0];
    rays.dir_y[i] = single.direction[1];
    rays.dir_z[i] = single.direction[2];
    rays.tfar[i] = single.tfar;
    rays.time[i] = 0;
    rays.mask[i] = ~0u;
    rays.id[i] = static_cast<unsigned>(i);
    rays.flags[i] = 0;
  }
}

// On processors without instructions for sixteen rays, Embree's emulation passes invalid rays to the
// leaves.
void EmbreeTree::nearest(std::span<Query* const> queries) const {
  if (!device_->has_packets()) {
    for (Query* const query : queries) nearest(*query);
    return;
  }
  alignas(64) int are_valid[packet_size];
  RTCRayHit16 hits;
  enter_all(queries, hits.ray, are_valid);
  for (std::size_t i = 0; i < packet_size; ++i) {
    hits.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    hits.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  Context context(queries.data());
  context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(are_valid, scene_.get(), &context.embree, &hits);
}

std::array<bool, packet_size> EmbreeTree::blocks(std::span<Query* const> queries) const {
  std::array<bool, packet_size> answers{};
  if (!device_->has_packets()) {
    for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = blocks(*queries[i]);
    return answers;
  }
  alignas(64) int are_valid[packet_size];
  RTCRay16 rays;
  enter_all(queries, rays, are_valid);
  Context context(queries.data());
  // Not as a coherent packet: Embree then visits a leaf with the same query more than once. It is no slower.
  rtcOccluded16(are_valid, scene_.get(), &context.embree, &rays);
  for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = are_valid[i] != 0 && rays.tfar[i] < 0;
  return answers;
}

} // namespace rt::bvh
