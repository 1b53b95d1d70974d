#include "renderer/render/estimate.hpp"

#include "renderer/integrators/occlusion.hpp"
#include "renderer/integrators/path/path_tracer.hpp"
#include "renderer/math/rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
namespace {

// The number of independent sequences of samples, whose means give the error of the whole.
constexpr std::uint32_t sequences = 16;
// Fewer may agree by chance.
constexpr std::uint32_t least_samples = 64;

class Means {
public:
  void add(std::uint32_t sequence, const Color& value) { sums_[sequence] += value; }

  Estimate estimate(std::uint32_t samples) const {
    const double each = samples / sequences;
    Color mean = black, squares = black;
    for (const Color& sum : sums_) mean += sum * (1 / each / sequences);
    for (const Color& sum : sums_) {
      const Color away = sum * (1 / each) - mean;
      squares += away * away;
    }
    return {mean, std::sqrt(max_component(squares) / (sequences * (sequences - 1))), samples};
  }

private:
  std::array<Color, sequences> sums_{};
};

// Doubles the samples, `draw` by `draw`, until they suffice.
template <class Draw>
Estimate refine(double precision, Draw&& draw) {
  Means means;
  std::uint32_t drawn = 0; // in each sequence
  for (std::uint32_t samples = sequences;; samples *= 2) {
    for (; drawn < samples / sequences; ++drawn)
      for (std::uint32_t sequence = 0; sequence < sequences; ++sequence)
        means.add(sequence, draw(SampleStream(sequence, 0, 0, drawn)));
    const Estimate estimate = means.estimate(samples);
    const bool is_precise = samples >= least_samples && Estimator::safety * estimate.error <= precision;
    if (is_precise || samples >= Estimator::most_samples) return estimate;
  }
}

} // namespace

Estimate Estimator::radiance(const std::function<Ray(const SampleStream&)>& make_ray, double precision) const {
  const auto estimate = [&](auto& tracer) {
    return refine(precision, [&](const SampleStream& stream) {
      const Ray ray = make_ray(stream);
      Color seen;
      tracer.radiance({&ray, 1}, {&stream, 1}, scene_.around(ray.origin), {&seen, 1});
      return seen;
    });
  };
  if (!paths_) {
    const auto integrator = make_occlusion(scene_);
    return estimate(*integrator->make_worker());
  }
  PathTracer tracer(*paths_, nullptr);
  return estimate(tracer);
}

Estimate Estimator::irradiance(const Vec3& point, const Vec3& normal, double precision) const {
  PathTracer tracer(*paths_, nullptr);
  const std::vector<Medium> inside = scene_.around(point + normal * (rounding_bound(64) * (magnitude(point) + 1)));
  return refine(precision,
                [&](const SampleStream& stream) { return tracer.irradiance(point, normal, stream, inside); });
}

} // namespace rt
