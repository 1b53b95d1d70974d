#pragma once

#include "renderer/scene/scene.hpp"
#include "renderer/shapes/hit.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// How a ray meets a shape, worked out on paper's terms from what the scene says of the shape: equation, coefficients,
/// roots, tests. The hit is the tracer's; this stands beside it and says how well both agree.
namespace rt::tools::explain {

/// A number or a vector with its name and how it comes about.
struct Quantity {
  std::string key;   ///< unique within a derivation: "a"
  std::string label; ///< with the formula: "a = d·d"
  std::variant<double, Vec3> value;
};

/// Quantities that belong together, and what follows from them.
struct DerivationLine {
  std::vector<Quantity> quantities;
  std::string words;
};

struct Derivation {
  std::string shape;         ///< its noun
  std::string equation;      ///< what the points of its surface satisfy
  bool is_own_space = false; ///< the shape is turned, scaled or sheared: the ray was carried to the shape's own space
  Ray ray;                   ///< in the space of the derivation; t is the same in both
  std::vector<DerivationLine> lines;
  std::string choice;      ///< which of several places was taken, and why
  double t = 0;            ///< as derived
  double disagreement = 0; ///< with the tracer's t, relative to it
};

/// Of the innermost object of `path`, which must be a shape that the tracer found the ray to meet at `found`. `ray` is
/// the scene's. An operand of a combination: not each of the shape's surfaces counts.
Derivation derive(const scene::Scene& scene, std::span<const std::uint32_t> path, const Ray& ray, const Hit& found,
                  bool is_operand);

/// The map from the innermost object's own space to the scene's.
Affine map_of(const scene::Scene& scene, std::span<const std::uint32_t> path);

} // namespace rt::tools::explain
