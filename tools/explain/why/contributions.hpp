#pragma once

#include "tools/explain/why/ray_tree.hpp"

#include <cstdint>
#include <vector>

namespace rt::tools::explain {

/// How light seen in one surface got there.
struct WayStep {
  enum class How : std::uint8_t { mirrored, refracted, crossed, totally_reflected };
  How how;
  const SurfaceNode* at;
  std::uint32_t before; ///< index of the step before it, `no_step` for the first
};
inline constexpr std::uint32_t no_step = 0xffffffff;

/// A term of the shading equation with its weight in the first ray's radiance.
struct Contribution {
  enum class Kind : std::uint8_t { ambient, emission, diffuse, highlight, background, estimate, unexpanded };
  Kind kind;
  Color value;
  const SurfaceNode* surface = nullptr; ///< none for the background, an estimate and what was not expanded
  std::uint32_t light = 0;              ///< of diffuse light and highlights
  std::uint32_t last_step = no_step;    ///< of the way from the first surface to this one, in `Sum::steps`
};

/// A ray that ended because it would have been too deep.
struct Cut {
  Color weight;
  std::uint32_t last_step = no_step;
};

/// A ray tree, decomposed.
struct Sum {
  std::vector<Contribution> terms; ///< those that are not 0, in the order of the tree; they add up to the radiance
  std::vector<Cut> cuts;
  std::vector<WayStep> steps;
  Color total; ///< of the terms

  /// From the first surface on.
  std::vector<WayStep> way(std::uint32_t last_step) const;
};

Sum take_apart(const RayNode& root);

/// The size of a colour for comparing contributions.
inline double size_of(const Color& c) {
  return c.r + c.g + c.b;
}

} // namespace rt::tools::explain
