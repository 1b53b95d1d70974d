#pragma once

#include "renderer/bvh/bvh.hpp"
#include "renderer/compile/material_bindings.hpp"
#include "renderer/compile/ray_hit.hpp"
#include "renderer/shading/media.hpp"
#include "renderer/shapes/hit.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

/// The queries that traverse the trees of a compiled scene.
namespace rt {

/// How far behind the nearest hit another one may lie and still coincide with it, up to rounding: far beyond the error
/// bounds, unless the ray all but grazes the surfaces. Hits that close are examined exactly.
struct Slack {
  double fixed = 0; ///< for the ray's origin and the extent of the scene
  double end(double t) const { return t + std::abs(t) * 0x1p-30 + fixed; }
};

/// Looks for the nearest hit, and for others that contest it.
struct NearestQuery : bvh::Query {
  NearestQuery(const Ray& r, const Interval& i, const Slack& near, const Aggregate& a, std::uint64_t b, RayHit& h,
               TraceScratch& s)
      : Query(r, i), slack(near), aggregate(a), base(b), best(h), scratch(s) {}

  /// Accepts the hit unless there is an equally near one on an object declared earlier, or on an earlier leaf of the
  /// same object. Returns whether it was accepted.
  bool offer(const Hit& hit, std::uint32_t slot, std::uint32_t index, const LeafKind& kind, const void* leaves);

  Slack slack;                ///< of the whole scene's ray: t is the same in all spaces
  const Aggregate& aggregate; ///< whose tree it is in
  std::uint64_t base;         ///< the order of the aggregate's first object, in this instance of it
  RayHit& best;               ///< of the whole scene so far
  TraceScratch& scratch;
};

/// The material that leaves without one inherit, and the ray in the space where it is evaluated.
struct InheritedBinding {
  BindingId binding;
  const Ray* ray;
};

/// Looks for occluders: an opaque leaf ends the search, a transparent one leaves an attenuation.
struct ShadowQuery : bvh::Query {
  ShadowQuery(const Ray& r, const Interval& i, const Aggregate& a, std::uint64_t b, const MaterialBindings& all,
              const InheritedBinding& from_outside, TraceScratch& s)
      : Query(r, i), aggregate(a), base(b), bindings(all), inherited(from_outside), scratch(s) {}

  BindingId resolved(BindingId binding) const { return binding == inherited_binding ? inherited.binding : binding; }
  /// Of a leaf's surface at the ray's t.
  Color transmittance(BindingId binding, double t) const {
    return binding == inherited_binding ? bindings.transmittance(inherited.binding, inherited.ray->at(t))
                                        : bindings.transmittance(binding, ray.at(t));
  }
  void add_attenuation(double t, std::uint32_t slot, std::uint32_t sequence, const Color& transmittance);

  const Aggregate& aggregate;
  std::uint64_t base;
  const MaterialBindings& bindings;
  InheritedBinding inherited;
  TraceScratch& scratch;
  bool inspects = false; ///< it is an InspectQuery
};

/// Visits everything: all hits of the ray in its interval, or all solids around its origin.
struct InspectQuery : ShadowQuery {
  using ShadowQuery::ShadowQuery;

  void add_hit(const Boundary& hit, std::uint32_t index, const LeafKind& kind, const void* leaves);
  void add_around(std::uint32_t slot, BindingId medium);

  std::vector<RayHit>* hits = nullptr;
  std::vector<Medium>* around = nullptr;
};

} // namespace rt
