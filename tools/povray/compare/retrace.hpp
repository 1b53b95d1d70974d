#pragma once

#include "renderer/render/film.hpp"
#include "renderer/render/ray_query.hpp"
#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <limits>
#include <memory>

namespace rt::tools::povray {

/// What the ray through a pixel's centre hits first.
struct CenterHit {
  std::uint32_t id = 0; ///< of the object, 0 for nothing
  double distance = std::numeric_limits<double>::infinity();
  Vec3 normal{}; ///< unit, facing the viewer
};

/// Retraces single pixels of a scene, to find out why POV-Ray's picture differs. By its rules (`HitRules::povray`)
/// indices of refraction are rounded to 32 bits as well.
class Retracer {
public:
  explicit Retracer(const scene::Scene& scene);
  ~Retracer();

  /// By POV-Ray's rules.
  Rgb32 color(int x, int y);
  /// Whether the pixel has that colour, within `tolerance`, for rays rotated by no more than 1e-12: then it depends on
  /// the last digits, as where a ray after many bounces hits the edge of a pattern far away.
  bool is_unstable(int x, int y, const Rgb32& color, double tolerance);
  CenterHit hit(int x, int y, HitRules rules);
  /// Whether POV-Ray's rules can turn `ours` into `theirs`: by them ours is too near or too far away, or a ray of ours
  /// hits theirs beside the centre ray, within the reach of the rules (4e-6, and 5e-7 of the distance), first or at the
  /// same place.
  bool is_within_reach(int x, int y, const CenterHit& ours, const CenterHit& theirs);
  /// Whether a ray beside the centre ray (1e-9 of its length off, in one of eight directions) hits `id`.
  bool is_hit_beside(int x, int y, std::uint32_t id);
  /// Whether the centre ray also hits `id`, within 1e-6 of the distance of its first hit.
  bool is_hit_behind(int x, int y, std::uint32_t id);

private:
  const RayQuery& query(HitRules rules = HitRules::own);
  Ray beside(const Ray& ray, int i, double size) const;
  template <class Turn>
  Rgb32 color(int x, int y, Turn&& turn);

  scene::Scene scene_;
  std::unique_ptr<RayQuery> own_, povray_; ///< created on first use: most pictures need none
};

/// The largest difference of a channel, absolute or, above 1, relative.
double color_difference(const Rgb32& a, const Rgb32& b);

} // namespace rt::tools::povray
