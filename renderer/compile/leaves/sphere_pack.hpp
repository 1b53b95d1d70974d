#pragma once

#include "renderer/shapes/sphere.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace rt {

/// Eight spheres that are tested at once.
struct alignas(64) SpherePack {
  static constexpr std::uint32_t size = 8;
  std::array<double, size> x, y, z; ///< of the centres
  std::array<double, size> radius;  ///< NaN where there is no sphere

  SphereGeometry sphere(std::uint32_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
};

/// The chords of a ray's line in eight spheres. The arithmetic is that of `intersect` for one sphere, operation by
/// operation, so the chords are bit-identical, whatever the width of the processor's registers.
class SpherePackChords {
public:
  /// A way to find them: one by one on any machine; on x86-64 two at a time, four at a time with AVX2, eight at a time
  /// with AVX-512.
  using Find = void(SpherePackChords&, const SpherePack&, const Ray&, double);
  /// All that this processor supports, the fastest last.
  static std::span<Find* const> ways();

  /// `inverse` is 1 / |direction|².
  SpherePackChords(const SpherePack& pack, const Ray& ray, double inverse, Find* find = best_find) {
    find(*this, pack, ray, inverse);
  }

  /// A bit for each sphere: the line hits it, and not only behind the ray's origin. Only those have chords.
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
