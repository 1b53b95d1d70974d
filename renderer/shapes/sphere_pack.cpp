#include "renderer/shapes/sphere_pack.hpp"

#include <emmintrin.h>

#include <cstring>
#include <iterator>

namespace rt {
namespace {

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));

// By reference and not as results: that would depend on what the compiler may assume of the processor.
template <class Lanes>
[[gnu::always_inline]] inline void load(Lanes& lanes, const double* from) {
  std::memcpy(&lanes, from, sizeof lanes);
}

template <class Lanes>
[[gnu::always_inline]] inline void store(double* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

// A bit for each lane of a comparison's answer.
template <class Answers>
[[gnu::always_inline]] inline unsigned bits(const Answers& answers) {
  __m128d two[sizeof(Answers) / sizeof(__m128d)];
  std::memcpy(two, &answers, sizeof two);
  unsigned bits = 0;
  for (std::size_t i = 0; i < std::size(two); ++i) bits |= static_cast<unsigned>(_mm_movemask_pd(two[i])) << 2 * i;
  return bits;
}

} // namespace

// Those of the spheres from `first` on, as many as there are lanes.
template <class Lanes>
[[gnu::always_inline]] inline unsigned SpherePackChords::find_lanes(const SpherePack& pack, std::uint32_t first,
                                                                    const Ray& ray, double inverse) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  Lanes x, y, z, radius;
  load(x, &pack.x[first]), load(y, &pack.y[first]), load(z, &pack.z[first]), load(radius, &pack.radius[first]);
  x -= o.x, y -= o.y, z -= o.z;
  const Lanes squared = radius * radius;
  const Lanes along = x * d.x + y * d.y + z * d.z;
  const Lanes power = x * x + y * y + z * z - squared;
  const Lanes middle = along * inverse;
  const Lanes ax = x - d.x * middle, ay = y - d.y * middle, az = z - d.z * middle;
  const Lanes half_squared = (squared - (ax * ax + ay * ay + az * az)) * inverse;
  store(&middle_[first], middle);
  store(&half_squared_[first], half_squared);
  store(&product_[first], power * inverse);
  return bits((half_squared >= 0) & ~((power > 0) & (along <= 0)));
}

void SpherePackChords::find_by_two(SpherePackChords& chords, const SpherePack& pack, const Ray& ray, double inverse) {
  chords.meets_ = chords.find_lanes<Two>(pack, 0, ray, inverse) | chords.find_lanes<Two>(pack, 2, ray, inverse) << 2;
}

__attribute__((target("avx2"))) void SpherePackChords::find_by_four(SpherePackChords& chords, const SpherePack& pack,
                                                                    const Ray& ray, double inverse) {
  chords.meets_ = chords.find_lanes<Four>(pack, 0, ray, inverse);
}

bool SpherePackChords::has_four() {
  return __builtin_cpu_supports("avx2") != 0;
}

SpherePackChords::Find* const SpherePackChords::best_find = has_four() ? find_by_four : find_by_two;

} // namespace rt
