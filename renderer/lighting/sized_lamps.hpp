#pragma once

#include "renderer/compile/compiled_scene.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// Whether the lamp is a visible sphere, or a sun visible as a disc. One that nothing blocks has no size: it is not a
/// physical object.
bool has_size(const Light& lamp);

/// The lamps of a scene that have a size. Their radiance is such that size changes only the edges of shadows: seen from
/// a point at the distance D from its centre, a sphere of radius r has radiance color · D²/r², color being what a lamp
/// without size would give there; a sun of half angle a has color/sin² a.
class SizedLamps {
public:
  explicit SizedLamps(std::span<const Light> lamps);

  bool is_empty() const { return list_.empty(); }

  struct Choice {
    std::uint32_t index;
    double probability;
  };
  /// Chooses one for a point, by how much light it gives there; nothing if none gives any.
  std::optional<Choice> choose(const Vec3& p, double u) const;
  double probability(std::uint32_t index, const Vec3& p) const;

  struct Direction {
    Vec3 to_lamp;    ///< unit
    double distance; ///< to the sphere; infinite for a sun
  };
  /// Samples a direction to one of them from p, which is outside of it, for uniform u and v. The density is
  /// uniform.
  Direction sample(std::uint32_t index, const Vec3& p, double u, double v) const;
  /// Per solid angle; 0 where p is not outside.
  double density(std::uint32_t index, const Vec3& p) const;
  /// Its radiance at p.
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
    Vec3 place;  // the centre of a sphere, or the direction to a sun
    double size; // radius of a sphere, or 1 − cos of a sun's half angle
  };
  double cap_height(const SizedLamp& lamp, const Vec3& p) const;
  double weight(const SizedLamp& lamp, const Vec3& p) const;

  std::vector<SizedLamp> list_;
};

} // namespace rt
