#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/path/path_scene.hpp"
#include "renderer/sampling/sobol.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace rt {

/// A mean of samples, and how sure it is.
struct Estimate {
  Color mean = black;
  double error = 0; ///< the standard error, of the channel where it is greatest
  std::uint32_t samples = 0;
};

/// What modes with random samples find in a scene at single places, as precisely as is asked for, and the same each
/// time.
class Estimator {
public:
  /// The scene must outlive it. `follows_paths`: else it estimates how open surfaces are, and knows no irradiance.
  explicit Estimator(const CompiledScene& scene, bool follows_paths = true) : scene_(scene) {
    if (follows_paths) paths_.emplace(scene);
  }

  /// The light that comes in along rays (unit directions), each of which is made of a sample's numbers.
  Estimate radiance(const std::function<Ray(const SampleStream&)>& make_ray, double precision) const;
  /// The light that falls on a small surface at a point, from the side that its unit normal points to.
  Estimate irradiance(const Vec3& point, const Vec3& normal, double precision) const;

  /// An estimate is as precise as asked for where this many standard errors are within the precision.
  static constexpr double safety = 4;
  /// And where it is not after so many samples, it is left as it is.
  static constexpr std::uint32_t most_samples = 1 << 20;

private:
  const CompiledScene& scene_;
  std::optional<PathScene> paths_;
};

} // namespace rt
