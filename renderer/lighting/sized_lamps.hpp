#pragma once

#include "renderer/compile/compiled_scene.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// Whether the lamp is a ball that is seen, or a sun that is seen as a disc. One that nothing blocks has no size: it is
/// no thing of this world.
bool has_size(const Light& lamp);

/// The lamps of a scene that have a size. Their radiance is such that their size changes nothing but the edges of
/// shadows: seen from a point at the distance D from its middle, a ball of radius r shines with color · D²/r², color
/// being what a lamp without size would give there; a sun of half angle a with color/sin² a.
class SizedLamps {
public:
  explicit SizedLamps(std::span<const Light> lamps);

  bool is_empty() const { return list_.empty(); }

  struct Choice {
    std::uint32_t index;
    double probability;
  };
  /// Picks one for a point, by how much light it gives there; nothing where none does.
  std::optional<Choice> choose(const Vec3& p, double u) const;
  double probability(std::uint32_t index, const Vec3& p) const;

  struct Direction {
    Vec3 to_lamp;    ///< unit
    double distance; ///< to the ball; infinite for a sun
  };
  /// Draws a direction to one of them from p, which is outside of it, for u and v that are spread evenly. All are drawn
  /// with the same density.
  Direction sample(std::uint32_t index, const Vec3& p, double u, double v) const;
  /// Per solid angle; 0 where p is not outside.
  double density(std::uint32_t index, const Vec3& p) const;
  /// What comes from it to p.
  Color radiance(std::uint32_t index, const Vec3& p) const;

  struct BallHit {
    std::uint32_t index;
    double distance;
  };
  /// The nearest ball in the way of a ray (unit direction) that meets nothing up to `end`.
  std::optional<BallHit> ball_on(const Ray& ray, double end) const;
  /// The sun that a ray sees that meets nothing at all, the next one after `after`.
  std::optional<std::uint32_t> sun_behind(const Vec3& direction, std::optional<std::uint32_t> after = {}) const;

private:
  struct SizedLamp {
    const Light* light;
    bool is_sun;
    Vec3 place;  // the middle of a ball, or the direction to a sun
    double size; // radius of a ball, or 1 − cos of a sun's half angle
  };
  double cap_height(const SizedLamp& lamp, const Vec3& p) const;
  double weight(const SizedLamp& lamp, const Vec3& p) const;

  std::vector<SizedLamp> list_;
};

} // namespace rt
