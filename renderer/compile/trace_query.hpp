#pragma once

#include "renderer/bvh/bvh.hpp"
#include "renderer/compile/material_bindings.hpp"
#include "renderer/shading/media.hpp"
#include "renderer/shapes/hit.hpp"

#include <cstdint>
#include <vector>

/// What travels through the trees of a compiled scene.
namespace rt {

class Aggregate;
struct LeafKind;

/// A leaf that a ray met, and where: enough to work out the rest for the one that counts.
struct RayHit {
  double t = std::numeric_limits<double>::max();
  std::uint32_t shape_part = 0;   ///< `Hit::part`
  std::uint32_t index = 0;        ///< of the leaf, in its set
  std::uint32_t operand = 0;      ///< of a combination
  bool is_flipped = false;        ///< a surface of what is subtracted: the solid is on its other side
  const LeafKind* kind = nullptr; ///< none: no hit
  const void* leaves = nullptr;   ///< the set
  const Aggregate* aggregate = nullptr;
  std::uint64_t base = 0; ///< the order of the assembly's first leaf, where this instance of it stands

  explicit operator bool() const { return kind != nullptr; }
};

/// Where a line meets the boundary of a combination.
struct Boundary {
  double t = 0;
  std::uint32_t shape_part = 0;
  std::uint32_t operand = 0;
  bool is_flipped = false; ///< of what is subtracted
  bool is_entry = false;   ///< the line enters there
};

/// A transparent surface on a shadow ray's way.
struct ShadowAttenuation {
  double t;
  std::uint64_t order; ///< of the object; then of the surface within it
  std::uint32_t sequence;
  Color transmittance;
};

/// Storage that tracing needs while it runs, kept from ray to ray. Each thread has its own.
struct TraceScratch {
  std::vector<Boundary> boundaries; ///< used as a stack
  std::vector<std::uint32_t> operands;
  std::vector<ShadowAttenuation> attenuations;
};

/// Looks for the nearest hit.
struct NearestQuery : bvh::Query {
  NearestQuery(const Ray& r, const Interval& i, const Aggregate& a, std::uint64_t b, RayHit& h, TraceScratch& s)
      : Query(r, i), aggregate(a), base(b), best(h), scratch(s) {}

  /// Takes the hit unless there is an equally near one on a leaf that was declared before. False: it was not taken.
  bool offer(const Hit& hit, std::uint32_t slot, std::uint32_t index, const LeafKind& kind, const void* leaves);

  const Aggregate& aggregate; ///< whose tree it is in
  std::uint64_t base;         ///< the order of the assembly's first leaf, where it stands
  RayHit& best;               ///< of the whole scene so far
  TraceScratch& scratch;
};

/// The material that leaves without one of their own have, and the ray in the space where it was written.
struct InheritedBinding {
  BindingId binding;
  const Ray* ray;
};

/// Looks for what is in the way of light: opaque leaves end it, transparent ones leave a filter.
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

/// Looks at everything: all hits of the ray in its interval, or all solids around its origin.
struct InspectQuery : ShadowQuery {
  using ShadowQuery::ShadowQuery;

  void add_hit(const Boundary& hit, std::uint32_t index, const LeafKind& kind, const void* leaves);
  void add_around(std::uint32_t slot, double ior);

  std::vector<RayHit>* hits = nullptr;
  std::vector<Medium>* around = nullptr;
};

} // namespace rt
