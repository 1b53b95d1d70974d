#pragma once

#include "renderer/math/ray.hpp"
#include "renderer/render/film.hpp"
#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <memory>

namespace rt {
class RayQuery;
}

namespace rt::tools::povray {

/// Traces single pixels of a scene again, to find out why POV-Ray's picture is another.
class Retracer {
public:
  explicit Retracer(const scene::Scene& scene);
  ~Retracer();

  /// The pixel's colour under POV-Ray's limits: no hit nearer than 1e-4 or farther than 1e7, no blocker nearer than
  /// 1e-3 to either end of a shadow ray, indices of refraction rounded to 32 bits.
  Rgb32 color(int x, int y);
  /// Whether the pixel has that colour, within `tolerance`, for rays turned by no more than 1e-12: then it hangs on the
  /// last digits, as where a ray after many turns meets the edge of a pattern far away.
  bool is_unstable(int x, int y, const Rgb32& color, double tolerance);
  /// The number of the object that the centre ray meets if nothing nearer than 1e-4 or farther than 1e7 counts.
  std::uint32_t hit_with_povray_limits(int x, int y);
  /// Whether a ray beside the centre ray (1e-9 of its length off, in one of eight directions) meets `id`.
  bool is_hit_beside(int x, int y, std::uint32_t id);
  /// Whether the centre ray meets `id` too, within 1e-6 of the distance of what it meets first.
  bool is_hit_behind(int x, int y, std::uint32_t id);

private:
  const RayQuery& query();
  Ray beside(const Ray& ray, int i, double size) const;
  template <class Turn>
  Rgb32 color(int x, int y, Turn&& turn);

  scene::Scene scene_;
  std::unique_ptr<RayQuery> query_; ///< made when it is first needed: most pictures need none
};

/// The largest difference of a channel, of 1 or of the value where that is greater.
double color_difference(const Rgb32& a, const Rgb32& b);

} // namespace rt::tools::povray
