#include "tools/bench/bars/native.hpp"

#include <embree3/rtcore.h>
#include <sys/resource.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace rt::tools::bench {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

float* new_vertices(RTCGeometry geometry, RTCFormat format, std::size_t floats_each, std::size_t count) {
  return static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, format, floats_each * sizeof(float), count));
}

unsigned* new_indices(RTCGeometry geometry, RTCFormat format, std::size_t each, std::size_t count) {
  return static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, format, each * sizeof(unsigned), count));
}

float* put(float* out, const Vec3& p) {
  *out++ = static_cast<float>(p.x);
  *out++ = static_cast<float>(p.y);
  *out++ = static_cast<float>(p.z);
  return out;
}

float* put(float* out, const Vec3& p, double radius) {
  out = put(out, p);
  *out++ = static_cast<float>(radius);
  return out;
}

void attach(RTCScene scene, RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

// Embree has no planes: a square much larger than the scene is used instead.
void add_square(std::vector<TriangleShape>& triangles, const FloorShape& floor) {
  constexpr double half = 1000;
  const double y = floor.height;
  const Vec3 a{-half, y, -half}, b{half, y, -half}, c{half, y, half}, d{-half, y, half};
  triangles.push_back({{a, b, c}, floor.finish});
  triangles.push_back({{a, c, d}, floor.finish});
}

Scene build(RTCDevice device, const Layout& layout) {
  Scene scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  if (!layout.balls.empty()) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    float* out = new_vertices(geometry, RTC_FORMAT_FLOAT4, 4, layout.balls.size());
    for (const BallShape& s : layout.balls) out = put(out, s.center, s.radius);
    attach(scene.get(), geometry);
  }
  if (!layout.tubes.empty()) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
    float* out = new_vertices(geometry, RTC_FORMAT_FLOAT4, 4, layout.tubes.size() * 2);
    unsigned* index = new_indices(geometry, RTC_FORMAT_UINT, 1, layout.tubes.size());
    for (std::size_t i = 0; i < layout.tubes.size(); ++i) {
      const TubeShape& s = layout.tubes[i];
      out = put(put(out, s.from, s.radius), s.to, s.radius);
      index[i] = static_cast<unsigned>(2 * i);
    }
    attach(scene.get(), geometry);
  }
  std::vector<TriangleShape> triangles = layout.triangles;
  for (const FloorShape& s : layout.floors) add_square(triangles, s);
  if (!triangles.empty()) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float* out = new_vertices(geometry, RTC_FORMAT_FLOAT3, 3, triangles.size() * 3);
    unsigned* index = new_indices(geometry, RTC_FORMAT_UINT3, 3, triangles.size());
    for (const TriangleShape& s : triangles)
      for (const Vec3& p : s.points) out = put(out, p);
    for (unsigned i = 0; i < 3 * triangles.size(); ++i) index[i] = i;
    attach(scene.get(), geometry);
  }
  rtcCommitScene(scene.get());
  return scene;
}

// Slightly off the surface, as single precision requires.
RTCRay single(const Ray& ray, double end) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = 1e-4f;
  r.tfar = end < 1e30 ? static_cast<float>(end) : 1e30f;
  r.mask = ~0u;
  return r;
}

} // namespace

double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + static_cast<double>(usage.ru_utime.tv_usec) * 1e-6;
}

TracingCost trace_exactly(const CompiledScene& scene, const FrameRays& rays) {
  TraceScratch scratch;
  TracingCost cost;
  const double start = cpu_seconds();
  for (const Ray& ray : rays.nearest) cost.hits += scene.nearest(ray, {}, scratch) ? 1 : 0;
  for (std::size_t i = 0; i < rays.shadow.size(); ++i)
    cost.hits += scene.transmittance(rays.shadow[i], {0, rays.shadow_ends[i]}, scratch) == black ? 1 : 0;
  cost.seconds = cpu_seconds() - start;
  return cost;
}

TracingCost trace_natively(const Layout& layout, const FrameRays& rays) {
  const Device device(rtcNewDevice("threads=1,set_affinity=0"));
  const Scene scene = build(device.get(), layout);
  TracingCost cost;
  const double start = cpu_seconds();
  for (const Ray& ray : rays.nearest) {
    RTCRayHit hit{single(ray, 1e300), {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene.get(), &context, &hit);
    cost.hits += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
  }
  for (std::size_t i = 0; i < rays.shadow.size(); ++i) {
    RTCRay ray = single(rays.shadow[i], rays.shadow_ends[i]);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene.get(), &context, &ray);
    cost.hits += ray.tfar < 0 ? 1 : 0;
  }
  cost.seconds = cpu_seconds() - start;
  return cost;
}

} // namespace rt::tools::bench
