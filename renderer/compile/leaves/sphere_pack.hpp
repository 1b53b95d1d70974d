#pragma once

#include "renderer/shapes/sphere.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace rt {

/// Eight spheres that are tested at a time.
struct alignas(64) SpherePack {
  static constexpr std::uint32_t size = 8;
  std::array<double, size> x, y, z; ///< of the centres
  std::array<double, size> radius;  ///< not a number where there is no sphere

  SphereGeometry sphere(std::uint32_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
};

/// The chords that a ray's line makes of eight spheres. The arithmetic is that of `intersect` for one sphere, operation
/// by operation, and so are the chords, bit by bit, whatever the processor's registers hold.
class SpherePackChords {
public:
  /// A way to find them: one by one on any machine; on x86-64 with two numbers in a register, with four where the
  /// processor has AVX2, with eight where it has AVX-512.
  using Find = void(SpherePackChords&, const SpherePack&, const Ray&, double);
  /// All that this processor has, the fastest last.
  static std::span<Find* const> ways();

  /// `inverse` is 1 / |direction|².
  SpherePackChords(const SpherePack& pack, const Ray& ray, double inverse, Find* find = best_find) {
    find(*this, pack, ray, inverse);
  }

  /// A bit for each sphere: the line meets it, and the ray is not on its way out. Only those have chords.
  unsigned meets() const { return meets_; }
  SphereChord operator[](std::uint32_t i) const { return {middle_[i], half_squared_[i], product_[i]}; }

private:
  static Find find_one_by_one, find_by_two, find_by_four, find_by_eight;
  template <class Lanes>
  void find_all(const SpherePack& pack, const Ray& ray, double inverse);
  template <class Lanes>
  void find_lanes(const SpherePack& pack, std::uint32_t first, const Ray& ray, double inverse, Lanes& half_squared,
                  Lanes& power, Lanes& along);

  static Find* const best_find;

  std::array<double, SpherePack::size> middle_, half_squared_, product_;
  unsigned meets_;
};

} // namespace rt
