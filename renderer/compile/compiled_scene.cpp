#include "renderer/compile/compiled_scene.hpp"

#include "renderer/compile/aggregate.hpp"
#include "renderer/compile/compile.hpp"
#include "renderer/math/rounding.hpp"
#include "renderer/math/static_vector.hpp"
#include "renderer/scene/validation/validate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace rt {
namespace {

// `binding` is the leaf's, or the one it inherits.
void settle_medium(LeafSurface& s, const MaterialBindings& bindings, const RayHit& hit, BindingId binding) {
  if (s.medium || binding == inherited_binding) return;
  s.medium = s.solids ? s.solids->medium(hit.index, bindings, binding) : binding;
}

LeafSurface surface_of_leaf(const MaterialBindings& bindings, const Ray& ray, const RayHit& hit) {
  LeafSurface s = hit.kind->surface(hit.leaves, bindings, ray, hit);
  settle_medium(s, bindings, hit, s.leaf_binding);
  return s;
}

// `first` is the order of the aggregate's first object.
LeafSurface surface_in(const Aggregate& aggregate, const MaterialBindings& bindings, const Ray& ray, const RayHit& hit,
                       std::uint64_t first) {
  if (&aggregate == hit.aggregate) return surface_of_leaf(bindings, ray, hit);
  std::uint32_t slot = 0;
  const Aggregate::Step& step = *aggregate.step_to(hit.base - first, slot);
  const InstanceLeaves::Instance& instance = step.leaves->instance(step.index);
  if (instance.part_begin) return surface_in(*instance.aggregate, bindings, ray, hit, first + step.order);
  LeafSurface s = surface_in(*instance.aggregate, bindings, instance.to_local.ray(ray), hit, first + step.order);
  s.point = mapped(s.point, instance.to_outer, instance.to_local);
  const BindingId binding = step.leaves->tag(step.index).binding_id();
  if (s.shading_normal) s.shading_normal->carry(instance.to_outer);
  if (s.bent_normal) s.bent_normal->carry(instance.to_local);
  if (s.binding == inherited_binding && binding != inherited_binding) s.bind(binding, bindings);
  settle_medium(s, bindings, hit, binding);
  return s;
}

// The product of the attenuations. They were found in no particular order, and a product's rounding depends on it.
Color through(std::vector<ShadowAttenuation>& attenuations) {
  if (attenuations.empty()) return white;
  std::sort(attenuations.begin(), attenuations.end(), [](const ShadowAttenuation& a, const ShadowAttenuation& b) {
    return std::tie(a.t, a.order, a.sequence) < std::tie(b.t, b.order, b.sequence);
  });
  Color left = white;
  for (const ShadowAttenuation& a : attenuations) left *= a.transmittance;
  return left;
}

} // namespace

CompiledScene::CompiledScene(const scene::Scene& scene, int threads, bvh::Builder builder, HitRules rules)
    : device_(std::make_shared<bvh::Device>(threads, builder)), background_(scene.background), ambient_(scene.ambient),
      max_depth_(scene::depth_limit(scene)), min_weight_(scene::min_weight(scene)),
      reach_(scene.reach.value_or(std::numeric_limits<double>::max())) {
  const auto bindings = std::make_shared<MaterialBindings>(validated(scene));
  bindings_ = bindings;
  objects_ = compile(scene, scene.objects, *device_, *bindings, {}, {}, rules);
  root_ = &objects_->root();
  absorbs_ = bindings_->absorbs();
  add_lights(scene);
}

CompiledScene::CompiledScene(const scene::Scene& scene, std::span<const Part> parts, CompileCache& cache)
    : background_(scene.background), ambient_(scene.ambient), max_depth_(scene::depth_limit(scene)),
      min_weight_(scene::min_weight(scene)), reach_(scene.reach.value_or(std::numeric_limits<double>::max())) {
  objects_ = cache.compile(scene, parts);
  device_ = cache.device_;
  bindings_ = cache.bindings_;
  root_ = &objects_->root();
  absorbs_ = bindings_->absorbs();
  add_lights(scene);
}

void CompiledScene::add_lights(const scene::Scene& scene) {
  lights_.reserve(scene.lights.size());
  for (const scene::Light& light : scene.lights) {
    lights_.push_back(make_light(light));
    if (const SkyEmitter* sky = std::get_if<SkyEmitter>(&lights_.back().emitter)) sky_ = *sky;
  }
}

Slack CompiledScene::slack(const Ray& ray) const {
  return {0x1p-30 * (magnitude(ray.origin) + root_->reach())};
}

RayHit CompiledScene::nearest(const Ray& ray, const Interval& range, TraceScratch& scratch) const {
  RayHit hit;
  NearestQuery query(ray, range, slack(ray), *root_, 0, hit, scratch);
  root_->nearest(query);
  return hit;
}

Color CompiledScene::transmittance(const Ray& ray, const Interval& range, TraceScratch& scratch) const {
  scratch.attenuations.clear();
  ShadowQuery query(ray, range, *root_, 0, *bindings_, {bindings_->default_binding(), &ray}, scratch);
  return root_->blocks(query) ? black : through(scratch.attenuations);
}

void CompiledScene::nearest(std::span<const Ray> rays, const Interval& range, std::span<RayHit> hits,
                            TraceScratch& scratch) const {
  if (rays.size() == 1) {
    hits[0] = nearest(rays[0], range, scratch);
    return;
  }
  StaticVector<NearestQuery, bvh::packet_size> queries;
  std::array<bvh::Query*, bvh::packet_size> packet;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits[i] = {};
    packet[i] = &queries.add([&] { return NearestQuery(rays[i], range, slack(rays[i]), *root_, 0, hits[i], scratch); });
  }
  root_->nearest(std::span(packet).first(rays.size()));
}

void CompiledScene::transmittance(std::span<const ShadowRay> rays, std::span<TraceScratch> scratch) const {
  StaticVector<ShadowQuery, bvh::packet_size> queries;
  std::array<bvh::Query*, bvh::packet_size> packet;
  const BindingId binding = bindings_->default_binding();
  for (std::size_t i = 0; i < rays.size(); ++i) {
    scratch[i].attenuations.clear();
    packet[i] = &queries.add([&] {
      return ShadowQuery(rays[i].ray, rays[i].range, *root_, 0, *bindings_, {binding, &rays[i].ray}, scratch[i]);
    });
  }
  const auto blocked = root_->blocks(std::span(packet).first(rays.size()));
  for (std::size_t i = 0; i < rays.size(); ++i)
    *rays[i].transmittance = blocked[i] ? black : through(scratch[i].attenuations);
}

// Objects that cast no shadow are rare: only if the nearest hit is on one is the rest of the ray examined, because an
// object that casts one may be at the same distance.
RayHit CompiledScene::nearest_casting(const Ray& ray, const Interval& range, TraceScratch& scratch) const {
  const RayHit nearest_hit = nearest(ray, range, scratch);
  if (!nearest_hit || casts_shadow(nearest_hit)) return nearest_hit;
  for (RayHit hit : all_hits(ray, range)) {
    if (!casts_shadow(hit)) continue;
    hit.is_contested = true; // maybe
    return hit;
  }
  return {};
}

bool CompiledScene::casts_shadow(const RayHit& hit) const {
  const Aggregate* aggregate = root_;
  for (std::uint64_t first = 0; aggregate != hit.aggregate;) {
    std::uint32_t slot = 0;
    const Aggregate::Step& step = *aggregate->step_to(hit.base - first, slot);
    if (!step.leaves->tag(step.index).casts_shadow) return false;
    aggregate = step.leaves->instance(step.index).aggregate;
    first += step.order;
  }
  if (!hit.kind->tag(hit.leaves, hit.index).casts_shadow) return false;
  if (hit.kind != &leaf_kind<SolidLeaves>) return true;
  return static_cast<const SolidLeaves*>(hit.leaves)->placed(hit.index).solid->operand(hit.operand).casts_shadow;
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
  const MaterialBindings& bindings = *bindings_;
  const LeafSurface s = surface_in(*root_, bindings, ray, hit, 0);
  const Vec3 &normal = s.point.normal, smooth = s.shading_normal ? s.shading_normal->value(normal) : normal;
  const BindingId medium = s.medium.value_or(bindings.default_binding());
  return {s.point,
          s.bent_normal ? s.bent_normal->value(smooth) : smooth,
          order(hit),
          bindings.material(s.binding),
          bindings.material(medium),
          s.pattern_point,
          bindings.ior(medium)};
}

const MaterialValues& CompiledScene::values(const Surface& surface, MaterialValues& scratch) const {
  return bindings_->values(surface.material_id, surface.pattern_point, scratch);
}

const Absorption& CompiledScene::absorption(const Medium& medium) const {
  return bindings_->absorption(medium.material_id);
}

bool CompiledScene::uses_ior() const {
  return bindings_->uses_ior();
}

std::uint64_t CompiledScene::order(const RayHit& hit) const {
  return hit.base + hit.aggregate->order(hit.kind->tag(hit.leaves, hit.index).slot);
}

void CompiledScene::inspect(const Ray& ray, const Interval& range, TraceScratch& scratch,
                            std::vector<RayHit>& hits) const {
  const MaterialBindings& bindings = *bindings_;
  InspectQuery query(ray, range, *root_, 0, bindings, {bindings.default_binding(), &ray}, scratch);
  query.inspects = true;
  query.hits = &hits;
  root_->blocks(query);
  std::stable_sort(hits.begin(), hits.end(), [&](const RayHit& a, const RayHit& b) {
    return std::tuple(a.t, order(a), a.leaves, a.index) < std::tuple(b.t, order(b), b.leaves, b.index);
  });
}

std::span<const RayHit> CompiledScene::hits_near(const Ray& ray, const Interval& range, const RayHit& nearest,
                                                 TraceScratch& scratch) const {
  scratch.hits.clear();
  const double end = slack(ray).end(nearest.t), before = std::nextafter(2 * nearest.t - end, -end);
  inspect(ray, {std::max(range.lower, before), std::min(range.upper, end)}, scratch, scratch.hits);
  return scratch.hits;
}

std::vector<RayHit> CompiledScene::all_hits(const Ray& ray, const Interval& range) const {
  TraceScratch scratch;
  std::vector<RayHit> hits;
  inspect(ray, range, scratch, hits);
  return hits;
}

std::vector<Medium> CompiledScene::around(const Vec3& p) const {
  std::vector<Medium> found;
  if (!uses_ior()) return found;
  TraceScratch scratch;
  const MaterialBindings& bindings = *bindings_;
  // Any direction will do: the query is about the boxes that contain its origin.
  const Ray ray{p, {1, 0, 0}};
  InspectQuery query(ray, {0, 0}, *root_, 0, bindings, {bindings.default_binding(), &ray}, scratch);
  query.inspects = true;
  query.around = &found;
  root_->blocks(query);
  std::sort(found.begin(), found.end(), [](const Medium& a, const Medium& b) { return a.id < b.id; });
  return found;
}

std::vector<std::uint32_t> CompiledScene::path(const RayHit& hit) const {
  std::vector<std::uint32_t> path;
  const Aggregate* aggregate = root_;
  std::uint32_t part_begin = 0;
  const auto append = [&](const std::vector<std::uint32_t>& part) {
    path.insert(path.end(), part.begin(), part.end());
  };
  for (std::uint64_t first = 0; aggregate != hit.aggregate;) {
    std::uint32_t slot = 0;
    const Aggregate::Step& step = *aggregate->step_to(hit.base - first, slot);
    const InstanceLeaves::Instance& instance = step.leaves->instance(step.index);
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
    append(solids.placed(hit.index).solid->path(hit.operand));
  }
  path.front() += part_begin;
  return path;
}

} // namespace rt
