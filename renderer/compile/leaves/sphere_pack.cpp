#include "renderer/compile/leaves/sphere_pack.hpp"

#include <cstring>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace rt {
namespace {

// By reference rather than by value: the ABI of vector values depends on the instruction set.
template <class Lanes>
[[gnu::always_inline]] inline void load(Lanes& lanes, const double* from) {
  std::memcpy(&lanes, from, sizeof lanes);
}

template <class Lanes>
[[gnu::always_inline]] inline void store(double* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

} // namespace

// For the spheres from `first` on, as many as there are lanes. Outputs what determines whether a sphere is hit.
template <class Lanes>
[[gnu::always_inline]] inline void SpherePackChords::find_lanes(const SpherePack& pack, std::uint32_t first,
                                                                const Ray& ray, double inverse, Lanes& half_squared,
                                                                Lanes& power, Lanes& along) {
  const Vec3 &o = ray.origin, &d = ray.direction;
  Lanes x, y, z, radius;
  load(x, &pack.x[first]), load(y, &pack.y[first]), load(z, &pack.z[first]), load(radius, &pack.radius[first]);
  x -= o.x, y -= o.y, z -= o.z;
  const Lanes squared = radius * radius;
  along = x * d.x + y * d.y + z * d.z;
  power = x * x + y * y + z * z - squared;
  const Lanes middle = along * inverse;
  const Lanes ax = x - d.x * middle, ay = y - d.y * middle, az = z - d.z * middle;
  half_squared = (squared - (ax * ax + ay * ay + az * az)) * inverse;
  store(&middle_[first], middle);
  store(&half_squared_[first], half_squared);
  store(&product_[first], power * inverse);
}

void SpherePackChords::find_one_by_one(SpherePackChords& chords, const SpherePack& pack, const Ray& ray,
                                       double inverse) {
  chords.meets_ = 0;
  for (std::uint32_t i = 0; i < SpherePack::size; ++i) {
    double half_squared, power, along;
    chords.find_lanes(pack, i, ray, inverse, half_squared, power, along);
    if (half_squared >= 0 && !(power > 0 && along <= 0)) chords.meets_ |= 1u << i;
  }
}

#ifdef __x86_64__
namespace {

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));
using Eight = double __attribute__((vector_size(64)));

} // namespace

// As many at a time as there are lanes.
template <class Lanes>
[[gnu::always_inline]] inline void SpherePackChords::find_all(const SpherePack& pack, const Ray& ray, double inverse) {
  constexpr std::uint32_t lanes = sizeof(Lanes) / sizeof(double);
  meets_ = 0;
  for (std::uint32_t first = 0; first < SpherePack::size; first += lanes) {
    Lanes half_squared, power, along;
    find_lanes(pack, first, ray, inverse, half_squared, power, along);
    const auto meets = (half_squared >= 0) & ~((power > 0) & (along <= 0));
    __m128d pairs[lanes / 2];
    std::memcpy(pairs, &meets, sizeof pairs);
    for (std::uint32_t i = 0; i < lanes; i += 2)
      meets_ |= static_cast<unsigned>(_mm_movemask_pd(pairs[i / 2])) << (first + i);
  }
}

void SpherePackChords::find_by_two(SpherePackChords& chords, const SpherePack& pack, const Ray& ray, double inverse) {
  chords.find_all<Two>(pack, ray, inverse);
}

__attribute__((target("avx2"))) void SpherePackChords::find_by_four(SpherePackChords& chords, const SpherePack& pack,
                                                                    const Ray& ray, double inverse) {
  chords.find_all<Four>(pack, ray, inverse);
}

// The compiler (g++ 12) generates slow code for comparisons of eight that are not written as masks.
__attribute__((target("avx512f,avx512dq"))) void
SpherePackChords::find_by_eight(SpherePackChords& chords, const SpherePack& pack, const Ray& ray, double inverse) {
  Eight half_squared, power, along;
  chords.find_lanes(pack, 0, ray, inverse, half_squared, power, along);
  const Eight zero{};
  const auto leaves = _mm512_mask_cmp_pd_mask(_mm512_cmp_pd_mask(power, zero, _CMP_GT_OQ), along, zero, _CMP_LE_OQ);
  chords.meets_ = _mm512_cmp_pd_mask(half_squared, zero, _CMP_GE_OQ) & ~unsigned{leaves};
}

std::span<SpherePackChords::Find* const> SpherePackChords::ways() {
  static constexpr std::array<Find*, 4> all{find_one_by_one, find_by_two, find_by_four, find_by_eight};
  const bool has_four = __builtin_cpu_supports("avx2") != 0;
  const bool has_eight = __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
  return std::span(all).first(has_eight ? 4 : has_four ? 3 : 2);
}

#else

std::span<SpherePackChords::Find* const> SpherePackChords::ways() {
  static constexpr std::array<Find*, 1> all{find_one_by_one};
  return all;
}

#endif

SpherePackChords::Find* const SpherePackChords::best_find = ways().back();

} // namespace rt
