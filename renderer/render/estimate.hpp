#pragma once

#include "renderer/compile/compiled_scene.hpp"
#include "renderer/integrators/path/path_scene.hpp"
#include "renderer/sampling/sobol.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace rt {

/// A mean of samples, and its error.
struct Estimate {
  Color mean = black;
  double error = 0; ///< the standard error, of the channel in which it is greatest
  std::uint32_t samples = 0;
};

/// What the modes with random samples compute at single places of a scene, as precisely as required, and
/// reproducibly.
class Estimator {
public:
  /// The scene must outlive it. `follows_paths`: else it estimates ambient occlusion, and no irradiance.
  explicit Estimator(const CompiledScene& scene, bool follows_paths = true) : scene_(scene) {
    if (follows_paths) paths_.emplace(scene);
  }

  /// The radiance along rays (unit directions), each made from a sample's numbers.
  Estimate radiance(const std::function<Ray(const SampleStream&)>& make_ray, double precision) const;
  /// The irradiance at a point, on the side that its unit normal points to.
  Estimate irradiance(const Vec3& point, const Vec3& normal, double precision) const;

  /// An estimate is precise enough once this many standard errors are within the precision.
  static constexpr double safety = 4;
  /// After this many samples it is accepted as it is.
  static constexpr std::uint32_t most_samples = 1 << 20;

private:
  const CompiledScene& scene_;
  std::optional<PathScene> paths_;
};

} // namespace rt
