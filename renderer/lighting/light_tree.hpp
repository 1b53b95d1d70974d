#pragma once

#include "renderer/math/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rt {

/// A lamp, or several, as a tree of lamps knows them: they lie within a ball, give off so much light together, on both
/// sides of surfaces whose normals, or their opposites, are within a cone.
struct LightBounds {
  Vec3 center{};
  double radius = 0;
  double power = 0;
  Vec3 axis{0, 0, 1};    ///< unit, of the cone
  double cos_spread = 0; ///< of its half angle, at most a right one
};

/// What holds both.
LightBounds united(const LightBounds& a, const LightBounds& b);

/// At least about how much of the light may get to a point, up to a factor: power·cos θ/d², θ being the least angle to
/// a normal that the bounds allow, and d not smaller than the radius. Whatever the unit of length, all importances keep
/// their ratios.
double importance(const LightBounds& bounds, const Vec3& p);

/// Lamps by place: picks one for a point, in a time that grows with the logarithm of their number. A. Conty Estevez and
/// C. Kulla, Importance Sampling of Many Lights with Adaptive Tree Splitting, HPG 2018, without the splitting.
class LightTree {
public:
  LightTree() = default;
  explicit LightTree(std::span<const LightBounds> lamps);

  struct Choice {
    std::uint32_t index;
    double probability;
  };
  /// For `u` in [0, 1) that is spread evenly. There must be a lamp.
  Choice choose(const Vec3& p, double u) const;
  /// How likely `choose` picks that lamp: the product of the probabilities of the turns that lead to it.
  double probability(std::uint32_t index, const Vec3& p) const;

private:
  struct Node {
    LightBounds bounds;
    std::uint32_t second = 0; ///< of two children, of which the first is the next node; of a lamp 0
    std::uint32_t lamp = 0;
    bool is_lamp() const { return second == 0; }
  };
  void build(std::span<std::uint32_t> lamps, std::span<const LightBounds> bounds, std::uint64_t way, int depth);
  double first_probability(std::size_t node, const Vec3& p) const;

  std::vector<Node> nodes_;
  std::vector<std::uint64_t> ways_; // by lamp: at the depth i, bit i says whether the second child leads there
};

} // namespace rt
