#pragma once

#include "renderer/math/color.hpp"
#include "renderer/shapes/hit.hpp"

#include <cstdint>
#include <vector>

namespace rt {

class Aggregate;
struct LeafKind;

/// A leaf that a ray hit, and where: enough to compute the full surface for the hit that counts.
struct RayHit : Hit {
  std::uint32_t index = 0;        ///< of the leaf, in its set
  std::uint32_t operand = 0;      ///< of a combination
  bool is_flipped = false;        ///< a surface of a subtracted solid: the combination is on its other side
  bool is_contested = false;      ///< another is so close behind it that rounding may have decided: see touching.hpp
  const LeafKind* kind = nullptr; ///< null: no hit
  const void* leaves = nullptr;   ///< the set
  const Aggregate* aggregate = nullptr;
  std::uint64_t base = 0; ///< the order of the aggregate's first object, in this instance of it

  explicit operator bool() const { return kind != nullptr; }
};

/// Where a line crosses the boundary of a combination.
struct Boundary : Hit {
  std::uint32_t operand = 0;
  bool is_flipped = false; ///< of a subtracted solid
  bool is_entry = false;   ///< the line enters there
};

/// A transparent surface that a shadow ray crosses.
struct ShadowAttenuation {
  double t;
  std::uint64_t order; ///< of the object; then of the surface within it
  std::uint32_t sequence;
  Color transmittance;
};

/// Storage that tracing needs, reused from ray to ray. Each thread has its own.
struct TraceScratch {
  std::vector<Boundary> boundaries; ///< used as a stack
  std::vector<std::uint32_t> operands;
  std::vector<ShadowAttenuation> attenuations;
  std::vector<RayHit> hits;
};

} // namespace rt
