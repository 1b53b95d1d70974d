#pragma once

#include "renderer/scene/shapes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

/// What the tests of shapes share.
namespace rt::tests {

/// Numbers that look random and are the same on every machine (Steele, Lea and Flood's SplitMix64). So that they are
/// with every compiler too, no more than one is drawn between two operators or in a call's arguments; braces have an
/// order.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  double number(double low, double high) { return low + (high - low) * 0x1p-53 * static_cast<double>(bits() >> 11U); }
  /// As likely between 1 and 10 as between 10 and 100.
  double magnitude(double low, double high) { return low * std::pow(high / low, number(0, 1)); }
  double sign() { return bits() % 2 == 0 ? 1 : -1; }
  double signed_magnitude(double low, double high) {
    const double side = sign();
    return side * magnitude(low, high);
  }
  Vec3 vector(double low, double high) { return {number(low, high), number(low, high), number(low, high)}; }
  Vec3 direction() {
    while (true) {
      const Vec3 v = vector(-1, 1);
      if (dot(v, v) < 1 && dot(v, v) > 0.01) return normalize(v);
    }
  }
  Vec3 within_ball(double radius) {
    const Vec3 way = direction();
    return way * number(0, radius);
  }
  /// In any direction, as long as `magnitude` says.
  Vec3 step(double low, double high) {
    const Vec3 way = direction();
    return way * magnitude(low, high);
  }

private:
  std::uint64_t state_;
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
