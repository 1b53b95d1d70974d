#pragma once

#include "renderer/integrators/integrator.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

/// Numbers that path mode estimates.
namespace rt::tests {

/// A mean of independent estimates and its standard error, channel green.
struct Estimate {
  double mean = 0, error = 0;
};

/// The light that comes in along a ray, from 16 sequences of `samples`/16 points, each with a seed of its own.
inline Estimate estimate(const CompiledScene& scene, const Ray& ray, std::uint32_t samples) {
  const auto integrator = make_integrator(IntegratorKind::path, scene);
  const auto worker = integrator->make_worker();
  const std::vector<Medium> inside = scene.around(ray.origin);
  constexpr std::uint32_t sequences = 16;
  std::array<double, sequences> means{};
  for (std::uint32_t seed = 0; seed < sequences; ++seed) {
    for (std::uint32_t i = 0; i < samples / sequences; ++i) {
      const SampleStream stream(seed, 0, 0, i);
      Color seen;
      worker->radiance({&ray, 1}, {&stream, 1}, inside, {&seen, 1});
      means[seed] += seen.g / (samples / sequences);
    }
  }
  double mean = 0, squares = 0;
  for (const double m : means) mean += m / sequences;
  for (const double m : means) squares += (m - mean) * (m - mean);
  return {mean, std::sqrt(squares / (sequences * (sequences - 1)))};
}

/// Within 4.5 standard errors (of 15 degrees of freedom: wrong once in 2,400 estimates, and the seeds are fixed), and
/// these are below `precision`.
inline void check_estimate(const Estimate& found, double expected, double precision) {
  INFO("found " << found.mean << " ± " << found.error << ", expected " << expected);
  CHECK(found.error <= precision);
  CHECK(std::abs(found.mean - expected) <= 4.5 * found.error + 1e-9 * (1 + std::abs(expected)));
}

/// The irradiance at the origin from above, as a white Lambert disc of radius 1e-6 there shows it: E = π L. What lies
/// there must be part of the scene already; `look_from` is where the eye is, near the disc.
inline Estimate irradiance(SceneBuilder& k, const Vec3& point, const Vec3& normal, std::uint32_t samples) {
  scene::Material white_matte;
  white_matte.diffuse = grey(1);
  scene::Disc patch;
  patch.normal = normal, patch.radius = 1e-3;
  k.add(k.shape(patch).at(point).with(k.material(white_matte)));
  const CompiledScene scene(k.scene, 1);
  const Estimate radiance = estimate(scene, {point + normal * 1e-3, -normal}, samples);
  return {radiance.mean * std::numbers::pi, radiance.error * std::numbers::pi};
}

} // namespace rt::tests
