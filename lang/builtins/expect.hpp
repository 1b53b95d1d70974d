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

/// What a ray hits first.
struct Sighting {
  double t = 0;                       ///< in multiples of the ray's direction
  double distance = 0;                ///< Euclidean
  Vec3 normal;                        ///< unit, geometric: pointing out of the solid
  std::vector<scene::Object> objects; ///< what was hit, outermost first; the last is the shape itself
  std::string title;                  ///< its name in messages
};

/// The light found, with the standard error if it is an estimate, and the number of samples taken.
struct LightAnswer {
  Color color;
  double error = 0;
  std::uint32_t samples = 0;
  bool is_precise = true; ///< 4 standard errors are within the requested precision
};

/// Observes a scene for the expectations in it. The language asks, and does not know who traces.
class Observer {
public:
  virtual ~Observer() = default;
  /// The camera's ray through a point of the picture; pixel (0, 0) has its centre at (0.5, 0.5).
  virtual Ray image_ray(double x, double y) const = 0;
  virtual std::optional<Sighting> nearest(const Ray& ray) const = 0;
  /// The t of all hits, in order.
  virtual std::vector<double> crossings(const Ray& ray) const = 0;
  /// Whether light is estimated from samples: then the following are as precise as requested, if possible.
  virtual bool estimates() const = 0;
  /// The linear radiance of a pixel inside the picture, before it is rounded for the film.
  virtual LightAnswer pixel_color(int x, int y, double precision) const = 0;
  /// The radiance along a ray; the length of its direction does not matter.
  virtual LightAnswer radiance(const Ray& ray, double precision) const = 0;
  /// The irradiance at a point on the side that the normal, of any length, points to. Only if light is
  /// estimated.
  virtual LightAnswer irradiance(const Vec3& point, const Vec3& normal, double precision) const = 0;
};

/// Makes an observer of a scene, which must outlive it.
using ObserverMaker = std::function<std::unique_ptr<Observer>(const scene::Scene& scene)>;

/// The outcome of a scene's expectations.
struct Expectations {
  std::size_t passed = 0;
  std::size_t failed = 0;
  std::vector<Diagnostic> failures; ///< one for each that failed, except those with an error of their own
};

} // namespace rt::lang
