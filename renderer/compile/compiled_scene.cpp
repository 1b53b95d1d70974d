#include "renderer/compile/compiled_scene.hpp"

#include "renderer/math/static_vector.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>
#include <utility>

namespace rt {
namespace {

// How a smooth triangle is shaded.
struct Smoothness {
  Vec3 weights;                // of its corners
  std::array<Vec3, 3> normals; // theirs
};

// A hit's surface on its way from the leaf's assembly out to the scene.
struct Resolved {
  LeafSurface leaf;
  std::uint64_t order = 0;
  std::optional<double> ior{}; // as soon as it is known
  std::optional<Smoothness> smoothness{};
};

// `style` is the leaf's or what it inherits.
void settle_medium(Resolved& r, const MaterialBindings& bindings, const RayHit& hit, BindingId binding) {
  if (r.ior || binding == inherited_binding) return;
  r.ior = r.leaf.solids ? r.leaf.solids->ior(hit.index, bindings, binding) : bindings.ior(binding);
}

Resolved resolve_leaf(const Aggregate& aggregate, const MaterialBindings& bindings, const Ray& ray, const RayHit& hit) {
  Resolved r{hit.kind->surface(hit.leaves, bindings, ray, hit),
             hit.base + aggregate.order(hit.kind->tag(hit.leaves, hit.index).slot)};
  settle_medium(r, bindings, hit, r.leaf.leaf_style);
  if (r.leaf.smooth)
    r.smoothness = Smoothness{barycentric(r.leaf.smooth->flat, r.leaf.point.position), r.leaf.smooth->normals};
  return r;
}

// `first` is the order of the assembly's first leaf.
Resolved resolve(const Aggregate& aggregate, const MaterialBindings& bindings, const Ray& ray, const RayHit& hit,
                 std::uint64_t first) {
  if (&aggregate == hit.aggregate) return resolve_leaf(aggregate, bindings, ray, hit);
  std::uint32_t slot = 0;
  const Aggregate::Step& step = *aggregate.step_to(hit.base - first, slot);
  const InstanceLeaves::Leaf& instance = step.leaves->leaf(step.index);
  if (instance.part_begin) return resolve(*instance.aggregate, bindings, ray, hit, first + step.order);
  Resolved r = resolve(*instance.aggregate, bindings, instance.to_local.ray(ray), hit, first + step.order);
  r.leaf.point = mapped(r.leaf.point, instance.to_outer, instance.to_local);
  const BindingId binding = step.leaves->tag(step.index).style_id();
  if (r.leaf.binding == inherited_binding && binding != inherited_binding) {
    r.leaf.binding = binding;
    r.leaf.pattern_point = bindings.pattern_point(binding, r.leaf.point.position);
  }
  settle_medium(r, bindings, hit, binding);
  if (r.smoothness)
    for (Vec3& normal : r.smoothness->normals) normal = instance.to_outer.normal(normal);
  return r;
}

// Corner normals are carried to the scene and normalised before they are interpolated, as POV-Ray does.
Vec3 smooth_normal(const Smoothness& s, const Vec3& geometric_normal) {
  const Vec3 n = normalize(s.normals[0]) * s.weights.x + normalize(s.normals[1]) * s.weights.y +
                 normalize(s.normals[2]) * s.weights.z;
  const double size = length(n);
  return size > 0 ? n / size : geometric_normal;
}

// What filters leave of light. They were found in no particular order, and products depend on it by their rounding.
Color through(std::vector<ShadowAttenuation>& attenuations) {
  if (attenuations.empty()) return white;
  std::sort(attenuations.begin(), attenuations.end(), [](const ShadowAttenuation& a, const ShadowAttenuation& b) {
    return std::tie(a.t, a.order, a.sequence) < std::tie(b.t, b.order, b.sequence);
  });
  Color left = white;
  for (const ShadowAttenuation& filter : attenuations) left *= filter.transmittance;
  return left;
}

} // namespace

CompiledScene::CompiledScene(const scene::Scene& scene, int threads, bvh::Builder builder)
    : CompiledScene(scene, Compiled(scene, threads, builder)) {}

CompiledScene::CompiledScene(const scene::Scene& scene, std::span<const Part> parts, CompileCache& cache)
    : CompiledScene(scene, Compiled(scene, parts, cache)) {}

CompiledScene::CompiledScene(const scene::Scene& scene, Compiled compiled)
    : compiled_(std::move(compiled)), background_(scene.background), ambient_(scene.ambient),
      max_depth_(scene.max_depth) {
  lights_.reserve(scene.lights.size());
  for (const scene::Light& light : scene.lights) lights_.push_back(make_light(light));
}

RayHit CompiledScene::nearest(const Ray& ray, const Interval& range, TraceScratch& scratch) const {
  RayHit hit;
  NearestQuery query(ray, range, compiled_.root(), 0, hit, scratch);
  compiled_.root().nearest(query);
  return hit;
}

Color CompiledScene::transmittance(const Ray& ray, const Interval& range, TraceScratch& scratch) const {
  scratch.attenuations.clear();
  ShadowQuery query(ray, range, compiled_.root(), 0, compiled_.bindings(),
                    {compiled_.bindings().default_binding(), &ray}, scratch);
  return compiled_.root().blocks(query) ? black : through(scratch.attenuations);
}

void CompiledScene::nearest(std::span<const Ray> rays, const Interval& range, std::span<RayHit> hits,
                            TraceScratch& scratch) const {
  StaticVector<NearestQuery, bvh::packet_size> queries;
  std::array<bvh::Query*, bvh::packet_size> packet;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = {};
    packet[i] = &queries.add([&] { return NearestQuery(rays[i], range, compiled_.root(), 0, hits[i], scratch); });
  }
  compiled_.root().nearest(std::span(packet).first(rays.size()));
}

void CompiledScene::transmittance(std::span<const ShadowRay> rays, std::span<TraceScratch> scratch) const {
  StaticVector<ShadowQuery, bvh::packet_size> queries;
  std::array<bvh::Query*, bvh::packet_size> packet;
  const BindingId binding = compiled_.bindings().default_binding();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    scratch[i].attenuations.clear();
    packet[i] = &queries.add([&] {
      return ShadowQuery(rays[i].ray, rays[i].range, compiled_.root(), 0, compiled_.bindings(), {binding, &rays[i].ray},
                         scratch[i]);
    });
  }
  const auto blocked = compiled_.root().blocks(std::span(packet).first(rays.size()));
  for (std::size_t i = 0; i < rays.size(); ++i)
    *rays[i].transmittance = blocked[i] ? black : through(scratch[i].attenuations);
}

bool CompiledScene::casts_shadow(const RayHit& hit) const {
  const Aggregate* aggregate = &compiled_.root();
  for (std::uint64_t first = 0; aggregate != hit.aggregate;) {
    std::uint32_t slot = 0;
    const Aggregate::Step& step = *aggregate->step_to(hit.base - first, slot);
    if (!step.leaves->tag(step.index).casts_shadow) return false;
    aggregate = step.leaves->leaf(step.index).aggregate;
    first += step.order;
  }
  if (!hit.kind->tag(hit.leaves, hit.index).casts_shadow) return false;
  if (hit.kind != &leaf_kind<SolidLeaves>) return true;
  return static_cast<const SolidLeaves*>(hit.leaves)->leaf(hit.index).solid->operand(hit.operand).casts_shadow;
}

Color CompiledScene::transmittance_by_steps(const Ray& ray, double end, double gap) const {
  Color left = white;
  double last = 0;
  for (const RayHit& hit : all_hits(ray, {gap, end})) {
    if (hit.t - last <= gap || !casts_shadow(hit)) continue;
    const Surface s = surface(ray, hit);
    MaterialValues scratch;
    const MaterialValues& v = values(s, scratch);
    if (v.refract == 0) return black;
    left *= v.color * v.refract;
    last = hit.t;
  }
  return left;
}

Surface CompiledScene::surface(const Ray& ray, const RayHit& hit) const {
  const MaterialBindings& bindings = compiled_.bindings();
  const Resolved r = resolve(compiled_.root(), bindings, ray, hit, 0);
  const Vec3& normal = r.leaf.point.normal;
  return {r.leaf.point.position, normal,           r.smoothness ? smooth_normal(*r.smoothness, normal) : normal,
          r.leaf.point.error,    r.order,          bindings.material(r.leaf.binding),
          r.leaf.pattern_point,  r.ior.value_or(1)};
}

std::vector<RayHit> CompiledScene::all_hits(const Ray& ray, const Interval& range) const {
  TraceScratch scratch;
  std::vector<RayHit> hits;
  const MaterialBindings& bindings = compiled_.bindings();
  InspectQuery query(ray, range, compiled_.root(), 0, bindings, {bindings.default_binding(), &ray}, scratch);
  query.inspects = true;
  query.hits = &hits;
  compiled_.root().blocks(query);
  const auto order = [](const RayHit& h) { return h.base + h.aggregate->order(h.kind->tag(h.leaves, h.index).slot); };
  std::stable_sort(hits.begin(), hits.end(),
                   [&](const RayHit& a, const RayHit& b) { return a.t < b.t || (a.t == b.t && order(a) < order(b)); });
  return hits;
}

std::vector<Medium> CompiledScene::around(const Vec3& p) const {
  std::vector<Medium> found;
  if (!uses_ior()) return found;
  TraceScratch scratch;
  const MaterialBindings& bindings = compiled_.bindings();
  // Any direction will do: the query is about the boxes that its origin is in.
  const Ray ray{p, {1, 0, 0}};
  InspectQuery query(ray, {0, 0}, compiled_.root(), 0, bindings, {bindings.default_binding(), &ray}, scratch);
  query.inspects = true;
  query.around = &found;
  compiled_.root().blocks(query);
  std::sort(found.begin(), found.end(), [](const Medium& a, const Medium& b) { return a.id < b.id; });
  return found;
}

std::vector<std::uint32_t> CompiledScene::path(const RayHit& hit) const {
  std::vector<std::uint32_t> path;
  const Aggregate* aggregate = &compiled_.root();
  std::uint32_t part_begin = 0;
  const auto append = [&](const std::vector<std::uint32_t>& part) {
    path.insert(path.end(), part.begin(), part.end());
  };
  for (std::uint64_t first = 0; aggregate != hit.aggregate;) {
    std::uint32_t slot = 0;
    const Aggregate::Step& step = *aggregate->step_to(hit.base - first, slot);
    const InstanceLeaves::Leaf& instance = step.leaves->leaf(step.index);
    if (instance.part_begin)
      part_begin = *instance.part_begin;
    else
      append(aggregate->path(step.slot));
    aggregate = instance.aggregate;
    first += step.order;
  }
  append(aggregate->path(hit.kind->tag(hit.leaves, hit.index).slot));
  if (hit.kind == &leaf_kind<SolidLeaves>) {
    const auto& solids = *static_cast<const SolidLeaves*>(hit.leaves);
    append(solids.leaf(hit.index).solid->path(hit.operand));
  }
  path.front() += part_begin;
  return path;
}

} // namespace rt
