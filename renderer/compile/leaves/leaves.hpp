#pragma once

#include "renderer/compile/csg.hpp"
#include "renderer/compile/geometries.hpp"
#include "renderer/compile/trace_query.hpp"

#include <optional>
#include <vector>

/// The leaves of the trees: sets of one kind each, whose callbacks the trees call.
namespace rt {

/// What every leaf has besides its geometry.
struct LeafTag {
  std::uint32_t slot; ///< its object's index in the aggregate, in the order of declaration; leaves may share one
  std::uint32_t binding : 31;
  std::uint32_t casts_shadow : 1;

  LeafTag(std::uint32_t object, BindingId b, bool shadow)
      : slot(object), binding(static_cast<std::uint32_t>(b) & 0x7fffffff), casts_shadow(shadow) {}
  BindingId binding_id() const { return BindingId{binding}; }
};

class SolidLeaves;

/// The surface at a hit, on its way from the leaf's aggregate out to the scene. It is constructed in place: a copy
/// would have to wait for every one of its parts to be written.
struct LeafSurface {
  SurfacePoint point;
  BindingId binding = inherited_binding;                 ///< of the surface
  BindingId leaf_binding = inherited_binding;            ///< of the leaf as a whole: it determines the medium
  Vec3 pattern_point{};                                  ///< unless the binding is inherited
  const SolidLeaves* solids = nullptr;                   ///< of a combination, whose medium may be another's
  std::optional<InterpolatedNormal> shading_normal = {}; ///< none: the point's
  std::optional<BindingId> medium = {};                  ///< as soon as it is known
  std::optional<BentNormal> bent_normal = {};            ///< where its material has bumps

  /// Takes `b` for the surface's binding, which is looked up in the space that the surface is in.
  [[gnu::always_inline]] void bind(BindingId b, const MaterialBindings& bindings) {
    binding = b;
    pattern_point = bindings.pattern_point(b, point.position);
    if (bindings.is_bumpy(b)) [[unlikely]]
      bend(bindings);
  }

private:
  [[gnu::noinline]] void bend(const MaterialBindings& bindings) {
    bent_normal = bindings.bent_normal(binding, pattern_point,
                                       shading_normal ? shading_normal->value(point.normal) : point.normal);
  }
};

/// Operations on a type-erased leaf: one table for each type of set. A leaf may hold several shapes; then `tag` and
/// `surface` count those, as the hits do, and `nearest` and `blocks` the leaves.
struct LeafKind {
  LeafTag (*tag)(const void* leaves, std::uint32_t index);
  LeafSurface (*surface)(const void* leaves, const MaterialBindings& bindings, const Ray& ray, const RayHit& hit);
  void (*nearest)(const void* leaves, std::uint32_t index, NearestQuery& query);
  bool (*blocks)(const void* leaves, std::uint32_t index, ShadowQuery& query);
};

template <class Leaves>
inline constexpr LeafKind leaf_kind{
    [](const void* leaves, std::uint32_t index) { return static_cast<const Leaves*>(leaves)->tag(index); },
    [](const void* leaves, const MaterialBindings& bindings, const Ray& ray, const RayHit& hit) {
      return static_cast<const Leaves*>(leaves)->surface(bindings, ray, hit);
    },
    [](const void* leaves, std::uint32_t index, NearestQuery& query) {
      static_cast<const Leaves*>(leaves)->nearest(index, query);
    },
    [](const void* leaves, std::uint32_t index, ShadowQuery& query) {
      return static_cast<const Leaves*>(leaves)->blocks(index, query);
    }};

/// Shapes of one kind that are placed in the same way.
template <class Placed>
class ShapeLeaves {
public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(shapes_.size()); }
  Box3 bounds(std::uint32_t i) const { return shapes_[i].box(); }
  LeafTag tag(std::uint32_t i) const { return tags_[i]; }
  std::uint32_t shape_count() const { return size(); }
  const Placed& shape(std::uint32_t i) const { return shapes_[i]; }
  void reserve(std::size_t count) { shapes_.reserve(count), tags_.reserve(count); }
  void add(Placed shape, LeafTag tag) { shapes_.push_back(std::move(shape)), tags_.push_back(tag); }

  void nearest(std::uint32_t i, NearestQuery& query) const {
    Hit hit;
    const Placed& p = shapes_[i];
    if (intersect(p.shape, p.carried(query.ray), query.interval, hit))
      query.offer(hit, tags_[i].slot, i, leaf_kind<ShapeLeaves>, this);
  }

  bool blocks(std::uint32_t i, ShadowQuery& query) const {
    if (query.inspects) [[unlikely]]
      return inspect(i, static_cast<InspectQuery&>(query));
    const LeafTag tag = tags_[i];
    if (!tag.casts_shadow) return false;
    const Placed& p = shapes_[i];
    Hit hit;
    if (query.bindings.is_opaque(query.resolved(tag.binding_id())))
      return intersect(p.shape, p.carried(query.ray), query.interval, hit);
    std::uint32_t sequence = 0;
    for (Interval rest = query.interval; intersect(p.shape, p.carried(query.ray), rest, hit); rest.lower = hit.t)
      query.add_attenuation(hit.t, tag.slot, sequence++, query.transmittance(tag.binding_id(), hit.t));
    return false;
  }

  LeafSurface surface(const MaterialBindings& bindings, const Ray& ray, const RayHit& hit) const {
    const Placed& p = shapes_[hit.index];
    const BindingId binding = tags_[hit.index].binding_id();
    LeafSurface s{p.point(ray, hit), binding, binding};
    if constexpr (requires { interpolated_normal(p.shape, s.point.position); })
      s.shading_normal = interpolated_normal(p.shape, s.point.position);
    if (binding != inherited_binding) s.bind(binding, bindings);
    return s;
  }

private:
  bool inspect(std::uint32_t i, InspectQuery& query) const;

  std::vector<Placed> shapes_;
  std::vector<LeafTag> tags_;
};

/// A combination as placed. The solid may be shared.
class SolidLeaves {
public:
  struct PlacedSolid {
    const CsgSolid* solid;
    bool is_in_place;   ///< the solid was built in the aggregate's space, and the maps are meaningless
    bool owns_material; ///< it has one itself
    Affine to_outer, to_local;
    Box3 box;
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(solids_.size()); }
  Box3 bounds(std::uint32_t i) const { return solids_[i].box; }
  LeafTag tag(std::uint32_t i) const { return tags_[i]; }
  const PlacedSolid& placed(std::uint32_t i) const { return solids_[i]; }
  void add(const PlacedSolid& solid, LeafTag tag) { solids_.push_back(solid), tags_.push_back(tag); }

  void nearest(std::uint32_t i, NearestQuery& query) const;
  bool blocks(std::uint32_t i, ShadowQuery& query) const;
  LeafSurface surface(const MaterialBindings& bindings, const Ray& ray, const RayHit& hit) const;

  /// The material of the interior: the combination's own, else that of its leftmost part that has an index of
  /// refraction. `inherited` is the binding that its parts inherit: its own if it has one.
  BindingId medium(std::uint32_t i, const MaterialBindings& bindings, BindingId inherited) const;

private:
  bool inspect(std::uint32_t i, InspectQuery& query) const;

  std::vector<PlacedSolid> solids_;
  std::vector<LeafTag> tags_;
};

/// A group that is placed several times is a separate aggregate, and each of its placements a leaf. So is a part of the
/// scene that was compiled separately.
class InstanceLeaves {
public:
  struct Instance {
    const Aggregate* aggregate;
    Affine to_outer, to_local;
    std::uint64_t order; ///< how many objects precede it in the aggregate that contains it
    /// For a part: where it starts in the scene's list. It was compiled in place, so rays and points need no map.
    std::optional<std::uint32_t> part_begin = {};
  };

  std::uint32_t size() const { return static_cast<std::uint32_t>(instances_.size()); }
  Box3 bounds(std::uint32_t i) const;
  LeafTag tag(std::uint32_t i) const { return tags_[i]; }
  const Instance& instance(std::uint32_t i) const { return instances_[i]; }
  void add(const Instance& instance, LeafTag tag) { instances_.push_back(instance), tags_.push_back(tag); }

  void nearest(std::uint32_t i, NearestQuery& query) const;
  bool blocks(std::uint32_t i, ShadowQuery& query) const;
  LeafSurface surface(const MaterialBindings&, const Ray&, const RayHit&) const; // never called: hits are within

private:
  std::vector<Instance> instances_;
  std::vector<LeafTag> tags_;
};

template <class Placed>
bool ShapeLeaves<Placed>::inspect(std::uint32_t i, InspectQuery& query) const {
  const Placed& p = shapes_[i];
  if (query.hits) {
    Hit hit;
    for (Interval rest = query.interval; intersect(p.shape, p.carried(query.ray), rest, hit); rest.lower = hit.t)
      query.add_hit({hit, 0, false, false}, i, leaf_kind<ShapeLeaves>, this);
  }
  if constexpr (Solidlike<typename Placed::G>) {
    const BindingId binding = query.resolved(tags_[i].binding_id());
    if (query.around && query.bindings.is_medium(binding) && contains(p.shape, p.carried(query.ray.origin)))
      query.add_around(tags_[i].slot, binding);
  }
  return false;
}

} // namespace rt
