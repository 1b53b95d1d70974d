#include "renderer/patterns/chance/fractal.hpp"

#include "renderer/math/noise.hpp"

#include <cmath>
#include <cstdint>

namespace rt {
namespace {

template <class F>
double mean_of_octaves(const scene::Fractal& pattern, const Vec3& p, int channel, F&& of_noise) {
  const auto mixed = [](std::uint64_t seed, int number) {
    return mixed_seed(seed, static_cast<std::uint64_t>(number));
  };
  const std::uint64_t seed = mixed(static_cast<std::uint64_t>(pattern.seed), channel);
  double sum = 0, weights = 0, weight = 1, scale = 1;
  for (int i = 0; i < pattern.octaves; ++i) {
    sum += weight * of_noise(gradient_noise(mixed(seed, i), p * scale));
    weights += weight;
    weight *= pattern.gain;
    scale *= pattern.lacunarity;
  }
  return sum / weights;
}

} // namespace

double fractal_noise(const scene::Fractal& pattern, const Vec3& p, int channel) {
  return mean_of_octaves(pattern, p, channel, [](double n) { return n; });
}

double turbulence(const scene::Fractal& pattern, const Vec3& p) {
  return mean_of_octaves(pattern, p, 0, [](double n) { return std::abs(n); });
}

} // namespace rt
