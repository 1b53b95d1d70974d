#include "renderer/compile/leaves/sphere_pack.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <limits>
#include <random>

using namespace rt;

namespace {

using Spheres = std::array<SphereGeometry, SpherePack::size>;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN(); // the radius where there is no sphere
constexpr SphereGeometry none{{0, 0, 0}, nothing};

SpherePack pack_of(const Spheres& spheres) {
  SpherePack pack;
  for (std::size_t i = 0; i < SpherePack::size; ++i) {
    pack.x[i] = spheres[i].center.x, pack.y[i] = spheres[i].center.y, pack.z[i] = spheres[i].center.z;
    pack.radius[i] = spheres[i].radius;
  }
  return pack;
}

// Which of the spheres are hit, a bit for each, and where.
unsigned hit_by(const Ray& ray, const SpherePack& pack, const Interval& range, std::array<double, SpherePack::size>& t,
                SpherePackChords::Find* way) {
  const SpherePackChords chords(pack, ray, 1 / dot(ray.direction, ray.direction), way);
  unsigned hits = 0;
  for (std::uint32_t i = 0; i < SpherePack::size; ++i) {
    if (((chords.meets() >> i) & 1) == 0) continue;
    Hit near, far, hit;
    chords[i].roots(near.t, far.t);
    if (!take_first(near, far, range, hit)) continue;
    hits |= 1u << i;
    t[i] = hit.t;
  }
  return hits;
}

// That each sphere of the pack is hit exactly as it is alone.
int check_alike(const Spheres& spheres, const Ray& ray, const Interval& range) {
  int count = 0;
  for (SpherePackChords::Find* way : SpherePackChords::ways()) {
    std::array<double, SpherePack::size> t;
    const unsigned hits = hit_by(ray, pack_of(spheres), range, t, way);
    count = 0;
    for (std::size_t i = 0; i < SpherePack::size; ++i) {
      Hit hit;
      const bool is_hit = intersect(spheres[i], ray, range, hit);
      REQUIRE(((hits >> i) & 1) == is_hit);
      if (!is_hit) continue;
      REQUIRE(std::bit_cast<std::uint64_t>(t[i]) == std::bit_cast<std::uint64_t>(hit.t));
      ++count;
    }
  }
  return count;
}

} // namespace

TEST_CASE("sphere pack: there is a way for any machine, and a faster one for this") {
#ifdef __x86_64__
  CHECK(SpherePackChords::ways().size() >= 2);
#else
  CHECK(SpherePackChords::ways().size() == 1);
#endif
}

TEST_CASE("sphere pack: eight spheres are hit as each of them alone, bit by bit") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> number(-2, 2);
  const auto point = [&] { return Vec3{number(engine), number(engine), number(engine)}; };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    Spheres spheres;
    for (SphereGeometry& s : spheres) s = {point(), std::abs(number(engine)) * 0.7};
    const double far = i % 3 == 0 ? 1e6 : 1;
    const Vec3 origin = point() * far, target = point();
    const Ray ray{origin, i % 5 == 0 ? target - origin : normalize(target - origin)};
    const Interval all, some{std::abs(number(engine)), 2 + number(engine)};
    hits += check_alike(spheres, ray, all) + check_alike(spheres, ray, some);
  }
  CHECK(hits > 1000);
}

TEST_CASE("sphere pack: limits, tangents and origins inside are as with one sphere") {
  const Spheres spheres{{{{0, 0, 0}, 1},
                         {{0, 1, 0}, 1},
                         {{0, 0, -3}, 1},
                         {{0, 0, 3}, 0.5},
                         none,
                         {{0, 3, 0}, 1},
                         {{0, 0, -1}, 0.5},
                         none}};
  const Ray ray{{0, 0, 2}, {0, 0, -1}};
  // Along it: the first from 1 to 3, the second touched at 2, the third from 4 to 6, the fourth behind the origin,
  // the sixth beside it, the seventh from 2.5 to 3.5.
  for (SpherePackChords::Find* way : SpherePackChords::ways()) {
    std::array<double, SpherePack::size> t;
    CHECK(hit_by(ray, pack_of(spheres), {}, t, way) == 0b0100'0111);
    CHECK(t[0] == 1);
    CHECK(t[1] == 2);
    CHECK(t[2] == 4);
    CHECK(t[6] == 2.5);
    CHECK(hit_by(ray, pack_of(spheres), {1, 3}, t, way) == 0b0100'0011); // open below, closed above
    CHECK(t[0] == 3);
  }
  CHECK(check_alike(spheres, {{0, 0, 0.5}, {0, 0, 1}}, {}) == 2);
  CHECK(check_alike(spheres, {{0, 0, 1}, {0, 0, 1}}, {}) > 0); // starts on the first
}

TEST_CASE("sphere pack: an empty place is never hit") {
  for (std::size_t place = 0; place < SpherePack::size; ++place) {
    Spheres spheres;
    spheres.fill(none);
    spheres[place] = {{0, 0, 0}, 1};
    for (SpherePackChords::Find* way : SpherePackChords::ways()) {
      std::array<double, SpherePack::size> t;
      CHECK(hit_by({{0, 0, 5}, {0, 0, -1}}, pack_of(spheres), {}, t, way) == 1u << place);
      CHECK(hit_by({{0, 0, 0}, {0, 0, -1}}, pack_of(spheres), {}, t, way) == 1u << place);
    }
  }
}
