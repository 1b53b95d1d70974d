#pragma once

#include "renderer/shapes/sphere.hpp"

#include <emmintrin.h>

#include <array>

namespace rt {

/// Four spheres that are tested at a time, two in each register. The arithmetic is that of `intersect` for one sphere,
/// operation by operation, and so are the results, bit by bit.
struct alignas(64) SpherePack {
  static constexpr std::uint32_t size = 4;
  std::array<double, size> x, y, z; ///< of the centres
  std::array<double, size> radius;  ///< not a number where there is no sphere

  SphereGeometry sphere(std::uint32_t i) const { return {{x[i], y[i], z[i]}, radius[i]}; }
};

namespace detail {

inline __m128d choose(__m128d mask, __m128d yes, __m128d no) {
  return _mm_or_pd(_mm_and_pd(mask, yes), _mm_andnot_pd(mask, no));
}

inline __m128d contains(const Interval& range, __m128d t) {
  return _mm_and_pd(_mm_cmpgt_pd(t, _mm_set1_pd(range.lower)), _mm_cmple_pd(t, _mm_set1_pd(range.upper)));
}

// Of the spheres `i` and `i` + 1.
inline unsigned intersect_two(const SpherePack& pack, std::uint32_t i, const Ray& ray, double inverse,
                              const Interval& range, double* t) {
  const __m128d x = _mm_load_pd(&pack.x[i]) - _mm_set1_pd(ray.origin.x);
  const __m128d y = _mm_load_pd(&pack.y[i]) - _mm_set1_pd(ray.origin.y);
  const __m128d z = _mm_load_pd(&pack.z[i]) - _mm_set1_pd(ray.origin.z);
  const __m128d r = _mm_load_pd(&pack.radius[i]), squared = r * r;
  const __m128d dx = _mm_set1_pd(ray.direction.x), dy = _mm_set1_pd(ray.direction.y), dz = _mm_set1_pd(ray.direction.z);
  const __m128d scale = _mm_set1_pd(inverse), zero = _mm_setzero_pd();
  const __m128d along = x * dx + y * dy + z * dz;
  const __m128d power = x * x + y * y + z * z - squared;
  const __m128d goes_away = _mm_and_pd(_mm_cmpgt_pd(power, zero), _mm_cmple_pd(along, zero));
  const __m128d middle = along * scale;
  const __m128d ax = x - dx * middle, ay = y - dy * middle, az = z - dz * middle;
  const __m128d half_squared = (squared - (ax * ax + ay * ay + az * az)) * scale;
  const __m128d meets = _mm_andnot_pd(goes_away, _mm_cmpge_pd(half_squared, zero));
  if (_mm_movemask_pd(meets) == 0) return 0;

  // As SphereChord::roots does, and take_first.
  const __m128d half = _mm_sqrt_pd(half_squared), is_ahead = _mm_cmpge_pd(middle, zero);
  const __m128d direct = choose(is_ahead, middle + half, middle - half);
  const __m128d other = power * scale / direct;
  const __m128d near = choose(is_ahead, other, direct), far = choose(is_ahead, direct, other);
  const __m128d has_near = contains(range, near), has_far = contains(range, far);
  _mm_storeu_pd(t, choose(has_near, near, far));
  return static_cast<unsigned>(_mm_movemask_pd(_mm_and_pd(meets, _mm_or_pd(has_near, has_far))));
}

} // namespace detail

/// The nearest crossing in the interval of each sphere that has one: those have their bits set in the result, and their
/// places in `t`.
inline unsigned intersect(const SpherePack& pack, const Ray& ray, const Interval& range,
                          std::array<double, SpherePack::size>& t) {
  const double inverse = 1 / dot(ray.direction, ray.direction);
  return detail::intersect_two(pack, 0, ray, inverse, range, &t[0]) |
         detail::intersect_two(pack, 2, ray, inverse, range, &t[2]) << 2;
}

} // namespace rt
