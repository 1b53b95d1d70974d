#pragma once

#include "renderer/math/ray.hpp"
#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Where a line is inside solids and what combinations make of that: interval lists, independent of the tracer's.
namespace rt::tools::explain {

/// The line is inside from `enter` to `leave`; both may be infinite.
struct LineInterval {
  double enter, leave;
};
using LineIntervals = std::vector<LineInterval>; ///< disjoint, in order

LineIntervals unite(const LineIntervals& a, const LineIntervals& b);
LineIntervals intersect(const LineIntervals& a, const LineIntervals& b);
LineIntervals subtract(const LineIntervals& a, const LineIntervals& b);

/// One operand of a combination along a line.
struct OperandIntervals {
  const scene::Object* object;
  LineIntervals inside;
};

/// A combination along a line.
struct CombinationIntervals {
  std::uint32_t depth = 0; ///< its index on the path
  scene::Combination::Operation operation;
  std::vector<OperandIntervals> operands; ///< the visible ones, in order
  LineIntervals inside;                   ///< of the whole
};

/// For the outermost combination on the path, along the scene's `ray`; none if there is none, or if it is nested too
/// deeply to be worked out by hand.
std::optional<CombinationIntervals> intervals_along(const scene::Scene& scene, std::span<const std::uint32_t> path,
                                                    const Ray& ray);

} // namespace rt::tools::explain
