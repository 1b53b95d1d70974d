#pragma once

#include "renderer/math/ray.hpp"
#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Where a line is inside of solids and what combinations make of them: interval lists, worked out beside the tracer.
namespace rt::tools::explain {

/// The line is inside from `enter` to `leave`; both may be infinite.
struct Stretch {
  double enter, leave;
};
using Stretches = std::vector<Stretch>; ///< apart from each other, in order

Stretches unite(const Stretches& a, const Stretches& b);
Stretches intersect(const Stretches& a, const Stretches& b);
Stretches subtract(const Stretches& a, const Stretches& b);

/// One operand of a combination along a line.
struct OperandStretches {
  const scene::Object* object;
  Stretches inside;
};

/// A combination along a line.
struct CombinationStretches {
  std::uint32_t depth = 0; ///< its position on the path
  scene::Combination::Operation operation;
  std::vector<OperandStretches> operands; ///< the visible ones, in order
  Stretches inside;                       ///< of the whole
};

/// Of the outermost combination that the path leads through, along the scene's `ray`; none if there is none, or if it
/// is nested too deep to be worked out by hand.
std::optional<CombinationStretches> stretches_along(const scene::Scene& scene, std::span<const std::uint32_t> path,
                                                    const Ray& ray);

} // namespace rt::tools::explain
