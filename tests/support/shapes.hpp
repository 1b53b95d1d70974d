#pragma once

#include "renderer/math/random.hpp"
#include "renderer/scene/shapes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

/// What the tests of shapes share.
namespace rt::tests {

/// Random numbers for shapes. So that they are the same with every compiler, no more than one is drawn between two
/// operators or in a call's arguments; braces have an order.
class Random : public SplitMix64 {
public:
  using SplitMix64::SplitMix64;

  /// As likely between 1 and 10 as between 10 and 100.
  double magnitude(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  double sign() { return bits() % 2 == 0 ? 1 : -1; }
  double signed_magnitude(double low, double high) {
    const double side = sign();
    return side * magnitude(low, high);
  }
  Vec3 vector(double low, double high) { return {between(low, high), between(low, high), between(low, high)}; }
  Vec3 direction() {
    while (true) {
      const Vec3 v = vector(-1, 1);
      if (dot(v, v) < 1 && dot(v, v) > 0.01) return normalize(v);
    }
  }
  Vec3 within_ball(double radius) {
    const Vec3 way = direction();
    return way * between(0, radius);
  }
  /// In any direction, as long as `magnitude` says.
  Vec3 step(double low, double high) {
    const Vec3 way = direction();
    return way * magnitude(low, high);
  }
};

/// All crossings in front of the ray's origin, one after the other.
template <class G>
std::vector<Hit> hits(const G& shape, const Ray& ray) {
  std::vector<Hit> found;
  Interval range;
  Hit hit;
  while (intersect(shape, ray, range, hit)) {
    found.push_back(hit);
    range.lower = hit.t;
    REQUIRE(found.size() < 100);
  }
  return found;
}

template <class G>
std::vector<double> distances(const G& shape, const Ray& ray) {
  std::vector<double> list;
  for (const Hit& hit : hits(shape, ray)) list.push_back(hit.t);
  return list;
}

/// Both lists hold the same numbers, to `relative` of each.
inline bool near(const std::vector<double>& found, const std::vector<double>& expected, double relative = 1e-15) {
  bool is_equal = found.size() == expected.size();
  for (std::size_t i = 0; is_equal && i < found.size(); ++i)
    is_equal = std::abs(found[i] - expected[i]) <= relative * std::abs(expected[i]);
  if (!is_equal) UNSCOPED_INFO("found " << Catch::Detail::stringify(found));
  return is_equal;
}

inline bool near(const Vec3& found, const Vec3& expected, double distance = 1e-15) {
  const bool is_equal = length(found - expected) <= distance;
  if (!is_equal) UNSCOPED_INFO("found (" << found.x << ", " << found.y << ", " << found.z << ")");
  return is_equal;
}

/// The first crossing's point and normal; there must be one.
template <class G>
SurfacePoint first_point(const G& shape, const Ray& ray) {
  Hit hit;
  REQUIRE(intersect(shape, ray, {}, hit));
  return surface_point(shape, ray, hit);
}

/// Enter and leave, or nothing.
template <class G>
std::vector<double> span(const G& shape, const Ray& ray) {
  std::vector<double> list;
  const Crossings found = crossings(shape, ray);
  for (int i = 0; i < found.count; ++i) list.push_back(found.at[static_cast<std::size_t>(i)].t);
  return list;
}

} // namespace rt::tests
