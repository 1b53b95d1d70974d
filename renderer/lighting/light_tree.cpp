#include "renderer/lighting/light_tree.hpp"

#include "renderer/math/box3.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

// cos and sin of the difference of two angles between 0 and 180°, or of 0 if the second is the greater.
struct Angle {
  double cosine, sine;
};
Angle operator-(const Angle& a, const Angle& b) {
  if (a.cosine >= b.cosine) return {1, 0};
  return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}
Angle with_cosine(double cosine) {
  return {cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine))};
}

// The cone about the sum of both axes that contains both. Wider than necessary if one has a much wider spread.
void unite_cones(LightBounds& all, const LightBounds& a, const LightBounds& b) {
  const double side = dot(a.axis, b.axis) < 0 ? -1 : 1;
  const Vec3 middle = normalize(a.axis + b.axis * side);
  const Angle half = with_cosine(std::min(1.0, dot(middle, a.axis)));
  const double widest = std::min(a.cos_spread, b.cos_spread);
  const Angle spread = with_cosine(widest);
  all.axis = middle;
  all.cos_spread = std::max(0.0, half.cosine * spread.cosine - half.sine * spread.sine);
}

} // namespace

LightBounds united(const LightBounds& a, const LightBounds& b) {
  LightBounds all;
  all.power = a.power + b.power;
  unite_cones(all, a, b);
  const Vec3 way = b.center - a.center;
  const double distance = length(way);
  if (distance + b.radius <= a.radius) {
    all.center = a.center, all.radius = a.radius;
  } else if (distance + a.radius <= b.radius) {
    all.center = b.center, all.radius = b.radius;
  } else {
    all.radius = (distance + a.radius + b.radius) / 2;
    all.center = a.center + way * ((all.radius - a.radius) / distance);
  }
  return all;
}

double importance(const LightBounds& bounds, const Vec3& p) {
  const Vec3 way = bounds.center - p;
  const double squared = dot(way, way), radius_squared = bounds.radius * bounds.radius;
  if (!(squared > radius_squared)) return radius_squared > 0 ? bounds.power / radius_squared : 0;
  const double to_axis = std::min(1.0, std::abs(dot(way, bounds.axis)) / std::sqrt(squared));
  const Angle seen_at{std::sqrt(1 - radius_squared / squared), std::sqrt(radius_squared / squared)};
  const Angle least = with_cosine(to_axis) - with_cosine(bounds.cos_spread) - seen_at;
  return bounds.power * std::max(0.0, least.cosine) / squared;
}

LightTree::LightTree(std::span<const LightBounds> lamps) : ways_(lamps.size()) {
  std::vector<std::uint32_t> order(lamps.size());
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(2 * lamps.size());
  if (!order.empty()) build(order, lamps, 0, 0);
}

// Halves the lamps along the axis of their greatest extent: no path is longer than it must be.
void LightTree::build(std::span<std::uint32_t> lamps, std::span<const LightBounds> bounds, std::uint64_t way,
                      int depth) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  if (lamps.size() == 1) {
    nodes_[node] = {bounds[lamps[0]], 0, lamps[0]};
    ways_[lamps[0]] = way;
    return;
  }
  Box3 box;
  for (const std::uint32_t lamp : lamps) box.extend(bounds[lamp].center);
  const Vec3 size = box.extent();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto place = [&](std::uint32_t lamp) {
    const Vec3& center = bounds[lamp].center;
    return axis == 0 ? center.x : axis == 1 ? center.y : center.z;
  };
  const auto middle = lamps.begin() + static_cast<std::ptrdiff_t>(lamps.size() / 2);
  std::sort(lamps.begin(), lamps.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(place(a), a) < std::pair(place(b), b); });
  build({lamps.begin(), middle}, bounds, way, depth + 1);
  const auto second = static_cast<std::uint32_t>(nodes_.size());
  build({middle, lamps.end()}, bounds, way | std::uint64_t{1} << depth, depth + 1);
  nodes_[node] = {united(nodes_[node + 1].bounds, nodes_[second].bounds), second, 0};
}

// If neither side seems to contribute, both are equally likely.
double LightTree::first_probability(std::size_t node, const Vec3& p) const {
  const double first = importance(nodes_[node + 1].bounds, p),
               second = importance(nodes_[nodes_[node].second].bounds, p);
  return first + second > 0 ? first / (first + second) : 0.5;
}

LightTree::Choice LightTree::choose(const Vec3& p, double u) const {
  double probability = 1;
  std::size_t node = 0;
  while (!nodes_[node].is_lamp()) {
    const double first = first_probability(node, p);
    if (u < first) {
      u /= first;
      probability *= first;
      ++node;
    } else {
      u = std::min((u - first) / (1 - first), 1 - 0x1p-53);
      probability *= 1 - first;
      node = nodes_[node].second;
    }
  }
  return {nodes_[node].lamp, probability};
}

double LightTree::probability(std::uint32_t index, const Vec3& p) const {
  double probability = 1;
  std::size_t node = 0;
  for (std::uint64_t way = ways_[index]; !nodes_[node].is_lamp(); way >>= 1) {
    const double first = first_probability(node, p);
    const bool is_second = way % 2 == 1;
    probability *= is_second ? 1 - first : first;
    node = is_second ? nodes_[node].second : node + 1;
  }
  return probability;
}

} // namespace rt
