#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "renderer/math/ray.hpp"
#include "renderer/scene/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rt::lang {

/// What a ray meets first.
struct Sighting {
  double t = 0;                       ///< in lengths of the ray's direction
  double distance = 0;                ///< Euclidean
  Vec3 normal;                        ///< unit, geometric: out of the solid
  std::vector<scene::Object> objects; ///< what was hit, outermost first; the last is the shape itself
  std::string title;                  ///< how it is called in messages
};

/// Light that was found, with the standard error of an estimate and how many samples that took.
struct LightAnswer {
  Color color;
  double error = 0;
  std::uint32_t samples = 0;
  bool is_precise = true; ///< 4 standard errors are within the precision that was asked for
};

/// Looks at one scene for the expectations in it. The language asks, and does not know who traces.
class Observer {
public:
  virtual ~Observer() = default;
  /// The camera's ray through a point of the picture; pixel (0, 0) has its centre at (0.5, 0.5).
  virtual Ray image_ray(double x, double y) const = 0;
  virtual std::optional<Sighting> nearest(const Ray& ray) const = 0;
  /// The t of all hits, in order.
  virtual std::vector<double> crossings(const Ray& ray) const = 0;
  /// Whether light is estimated, by samples: then the following are as precise as is asked for, if they can be.
  virtual bool estimates() const = 0;
  /// The linear radiance of a pixel inside the picture, before it is rounded for the film.
  virtual LightAnswer pixel_color(int x, int y, double precision) const = 0;
  /// The light that comes in along a ray, whatever the length of its direction.
  virtual LightAnswer radiance(const Ray& ray, double precision) const = 0;
  /// The light that falls on a point from the side that the normal, of whatever length, points to. Only where it is
  /// estimated.
  virtual LightAnswer irradiance(const Vec3& point, const Vec3& normal, double precision) const = 0;
};

/// Makes an observer of a scene that outlives it.
using ObserverMaker = std::function<std::unique_ptr<Observer>(const scene::Scene& scene)>;

/// What became of the expectations of a scene.
struct Expectations {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::vector<Diagnostic> failures; ///< one for each that failed, but for those with an error of their own
};

} // namespace rt::lang
