#include "renderer/shapes/sphere_pack.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <limits>
#include <random>

using namespace rt;

namespace {

SpherePack pack_of(const std::array<SphereGeometry, 4>& spheres) {
  SpherePack pack;
  for (std::size_t i = 0; i < 4; ++i) {
    pack.x[i] = spheres[i].center.x, pack.y[i] = spheres[i].center.y, pack.z[i] = spheres[i].center.z;
    pack.radius[i] = spheres[i].radius;
  }
  return pack;
}

// That each sphere of the pack is hit exactly as it is alone.
int check_alike(const std::array<SphereGeometry, 4>& spheres, const Ray& ray, const Interval& range) {
  std::array<double, 4> t;
  const unsigned hits = intersect(pack_of(spheres), ray, range, t);
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    Hit hit;
    const bool is_hit = intersect(spheres[i], ray, range, hit);
    REQUIRE(((hits >> i) & 1) == is_hit);
    if (!is_hit) continue;
    REQUIRE(std::bit_cast<std::uint64_t>(t[i]) == std::bit_cast<std::uint64_t>(hit.t));
    ++count;
  }
  return count;
}

} // namespace

TEST_CASE("sphere pack: four spheres are hit as each of them alone, bit by bit") {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> number(-2, 2);
  const auto point = [&] { return Vec3{number(engine), number(engine), number(engine)}; };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<SphereGeometry, 4> spheres;
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
  const std::array<SphereGeometry, 4> spheres{{{{0, 0, 0}, 1}, {{0, 1, 0}, 1}, {{0, 0, -3}, 1}, {{0, 0, 3}, 0.5}}};
  const Ray ray{{0, 0, 2}, {0, 0, -1}};
  // Along it: the first from 1 to 3, the second touched at 2, the third from 4 to 6, the last behind the origin.
  std::array<double, 4> t;
  CHECK(intersect(pack_of(spheres), ray, {}, t) == 0b0111);
  CHECK(t[0] == 1);
  CHECK(t[1] == 2);
  CHECK(t[2] == 4);
  CHECK(intersect(pack_of(spheres), ray, {1, 3}, t) == 0b0011); // open below, closed above
  CHECK(t[0] == 3);
  CHECK(check_alike(spheres, {{0, 0, 0.5}, {0, 0, 1}}, {}) == 2);
  CHECK(check_alike(spheres, {{0, 0, 1}, {0, 0, 1}}, {}) > 0); // starts on the first
}

TEST_CASE("sphere pack: an empty place is never hit") {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  const SpherePack pack = pack_of({{{{0, 0, 0}, 1}, {{0, 0, 0}, nothing}, {{0, 0, 0}, nothing}, {{0, 0, 0}, nothing}}});
  std::array<double, 4> t;
  CHECK(intersect(pack, {{0, 0, 5}, {0, 0, -1}}, {}, t) == 0b0001);
  CHECK(intersect(pack, {{0, 0, 0}, {0, 0, -1}}, {}, t) == 0b0001);
}
