#pragma once

#include "renderer/math/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// A lamp, or several, as a light tree sees them: they lie within a sphere and emit this much light together, on both
/// sides of surfaces whose normals, or their opposites, are within a cone.
struct LightBounds {
  Vec3 center{};
  double radius = 0;
  double power = 0;
  Vec3 axis{0, 0, 1};    ///< unit, of the cone
  double cos_spread = 0; ///< of its half angle, at most 90°
};

/// The bounds of both.
LightBounds united(const LightBounds& a, const LightBounds& b);

/// A rough upper bound on the light that may reach a point, up to a factor: power·cos θ/d², θ being the least angle to
/// a normal that the bounds allow, and d not smaller than the radius. Importances keep their ratios whatever the unit
/// of length.
double importance(const LightBounds& bounds, const Vec3& p);

/// Lamps by position: chooses one for a point, in time logarithmic in their number. A. Conty Estevez and C. Kulla,
/// Importance Sampling of Many Lights with Adaptive Tree Splitting, HPG 2018, without the splitting.
class LightTree {
public:
  LightTree() = default;
  explicit LightTree(std::span<const LightBounds> lamps);

  struct Choice {
    std::uint32_t index;
    double probability;
  };
  /// For a uniform `u` in [0, 1). There must be a lamp.
  Choice choose(const Vec3& p, double u) const;
  /// The probability that `choose` chooses that lamp: the product of those of the branches that lead to it.
  double probability(std::uint32_t index, const Vec3& p) const;

private:
  struct Node {
    LightBounds bounds;
    std::uint32_t second = 0; ///< of two children, the first being the next node; 0 for a lamp
    std::uint32_t lamp = 0;
    bool is_lamp() const { return second == 0; }
  };
  void build(std::span<std::uint32_t> lamps, std::span<const LightBounds> bounds, std::uint64_t way, int depth);
  double first_probability(std::size_t node, const Vec3& p) const;

  std::vector<Node> nodes_;
  std::vector<std::uint64_t> ways_; // by lamp: bit i says whether the second child leads there at depth i
};

} // namespace rt
