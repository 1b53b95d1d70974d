#pragma once

#include "renderer/scene/scene.hpp"
#include "renderer/shapes/hit.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// How a ray hits a shape, worked out as on paper from the description of the shape: equation, coefficients, roots,
/// tests. The hit is the tracer's; this is computed independently and reports how well they agree.
namespace rt::tools::explain {

/// A number or a vector with its name and its derivation.
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
  bool is_own_space = false; ///< the shape is rotated, scaled or sheared: the ray was transformed to object space
  Ray ray;                   ///< in the space of the derivation; t is the same in both
  std::vector<DerivationLine> lines;
  std::string choice;      ///< which of several candidates was taken, and why
  double t = 0;            ///< as derived
  double disagreement = 0; ///< with the tracer's t, relative to it
};

/// For the innermost object of `path`, which must be a shape that the tracer found the ray to hit at `found`. `ray` is
/// in scene space. For an operand of a combination, not all of the shape's surfaces count.
Derivation derive(const scene::Scene& scene, std::span<const std::uint32_t> path, const Ray& ray, const Hit& found,
                  bool is_operand);

/// The map from the innermost object's space to the scene's.
Affine map_of(const scene::Scene& scene, std::span<const std::uint32_t> path);

} // namespace rt::tools::explain
