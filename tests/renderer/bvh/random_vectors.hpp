#pragma once

#include "renderer/math/vec3.hpp"

#include <cstdint>
#include <random>

namespace rt::tests {

/// Numbers and vectors, the same on every run.
class RandomVectors {
public:
  explicit RandomVectors(std::uint64_t seed) : engine_(seed) {}

  double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  /// In a cube about the origin.
  Vec3 vector(double size) {
    const double x = (*this)(-size, size), y = (*this)(-size, size), z = (*this)(-size, size);
    return {x, y, z};
  }

private:
  std::mt19937_64 engine_;
};

} // namespace rt::tests
