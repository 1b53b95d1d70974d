#include "renderer/accel/tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

namespace rt::accel {
namespace {

constexpr float single_infinity = std::numeric_limits<float>::infinity();

// In the scaled space all of the scene lies within ±1, and a ray starts there and goes no farther than 2√3. To single
// precision (ε = 2⁻²⁴) its origin moves by ε/2 and its direction turns by ε. Embree's traversal (the fast one, whatever
// the scene's flags, for user geometries) gets each slab's t right to 5ε of t, and compares those of two axes: a slip
// of 2 · 5ε · 2√3 < 36ε in all. 64ε leaves room for t's own rounding and for the advance of origins that lie far away.
constexpr double padding = 0x1p-18;

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

// Whether the ray meets the box within its interval; if so, `start` is where it enters or already is inside.
bool meets(const Query& query, const Box3& box, double& start) {
  double from = query.interval.lower, to = query.interval.upper;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double o = query.ray.origin[axis], d = query.ray.direction[axis];
    if (d == 0) {
      if (o < box.lower[axis] || o > box.upper[axis]) return false;
      continue;
    }
    const double a = (box.lower[axis] - o) / d, b = (box.upper[axis] - o) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  start = from;
  return from <= to;
}

} // namespace

Device::Device(int threads)
    : device_(rtcNewDevice(("set_affinity=0,threads=" + std::to_string(std::max(threads, 0))).c_str())) {
  if (!device_)
    throw std::runtime_error("Embree cannot be started: error " + std::to_string(rtcGetDeviceError(nullptr)));
}

Tree::Tree(const Device& device, const Box3& bounds)
    : scene_(rtcNewScene(device.device_.get())), device_(&device), center_(bounds.center()) {
  check(device.device_.get());
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);

  const double extent = max_component(bounds.extent()) * 0.5;
  scale_ = extent > 0 ? std::exp2(-std::ceil(std::log2(extent))) : 1;
  // A ray is advanced to these bounds: a little wider than the leaves', so that its rounding misses none of them.
  const double margin = padding / scale_ + 0x1p-50 * max_component(abs(center_));
  bounds_ = {bounds.lower - Vec3{margin, margin, margin}, bounds.upper + Vec3{margin, margin, margin}};
}

void Tree::add(const Set& set, RTCIntersectFunctionN when_nearest, RTCOccludedFunctionN when_blocks) {
  RTCGeometry geometry = rtcNewGeometry(device_->device_.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, set.size);
  rtcSetGeometryBoundsFunction(geometry, &on_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, when_nearest);
  rtcSetGeometryOccludedFunction(geometry, when_blocks);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry); // the scene keeps it
  sets_.push_back(set);
  sets_.back().geometry = geometry;
}

void Tree::build() {
  for (Set& set : sets_) {
    set.tree = this;
    rtcSetGeometryUserData(set.geometry, &set); // for on_bounds
    rtcCommitGeometry(set.geometry);
  }
  rtcCommitScene(scene_.get());
  check(device_->device_.get());
  for (const Set& set : sets_) rtcSetGeometryUserData(set.geometry, const_cast<void*>(set.leaves)); // for the callbacks
  sets_ = {};
}

void Tree::on_bounds(const RTCBoundsFunctionArguments* args) {
  const Set& set = *static_cast<const Set*>(args->geometryUserPtr);
  *args->bounds_o = set.tree->to_single(set.bounds(set.leaves, args->primID));
}

RTCBounds Tree::to_single(const Box3& box) const {
  const Vec3 pad{padding, padding, padding};
  const Vec3 lower = (box.lower - center_) * scale_ - pad, upper = (box.upper - center_) * scale_ + pad;
  return {round_down(lower.x), round_down(lower.y), round_down(lower.z), 0,
          round_up(upper.x),   round_up(upper.y),   round_up(upper.z),   0};
}

bool Tree::enter(Query& query, RTCRay& ray) const {
  double start = 0;
  if (!meets(query, bounds_, start)) return false;
  const double speed = length(query.ray.direction);
  const Vec3 origin = (query.ray.at(start) - center_) * scale_, direction = query.ray.direction / speed;
  query.start_ = start;
  query.scale_ = speed * scale_;

  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0;
  ray.tfar = single_t(query);
  ray.time = 0;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
  return true;
}

void Tree::nearest(Query& query) const {
  RTCRayHit hit;
  if (!enter(query, hit.ray)) return;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Context context;
  rtcInitIntersectContext(&context.embree);
  context.query = &query;
  rtcIntersect1(scene_.get(), &context.embree, &hit);
}

bool Tree::blocks(Query& query) const {
  RTCRay ray;
  if (!enter(query, ray)) return false;
  Context context;
  rtcInitIntersectContext(&context.embree);
  context.query = &query;
  rtcOccluded1(scene_.get(), &context.embree, &ray);
  return ray.tfar < 0;
}

} // namespace rt::accel
