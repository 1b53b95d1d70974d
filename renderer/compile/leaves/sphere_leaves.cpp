#include "renderer/compile/leaves/sphere_leaves.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace rt {
namespace {

// Moves the spheres whose centre is below `value` to the front and returns their number. Branchless on the comparison,
// which no processor could predict.
template <class Added>
std::size_t split(std::span<Added> spheres, std::size_t axis, double value) {
  std::size_t below = 0;
  for (Added& a : spheres) {
    const bool is_below = a.sphere.center[axis] < value;
    std::swap(a, spheres[below]);
    below += is_below;
  }
  return below;
}

// std::nth_element by the centres' coordinate along an axis; delegates to it for the last few, or if the samples were
// misleading for too long.
template <class Added>
void select(std::span<Added> spheres, std::size_t n, std::size_t axis) {
  constexpr std::size_t sample_size = 15, few = 64;
  constexpr int most_splits = 32;
  for (int splits = 0; splits < most_splits && spheres.size() > few; ++splits) {
    std::array<double, sample_size> sample;
    for (std::size_t i = 0; i < sample_size; ++i)
      sample[i] = spheres[i * spheres.size() / sample_size].sphere.center[axis];
    const auto pivot = sample.begin() + static_cast<std::ptrdiff_t>(n * sample_size / spheres.size());
    std::nth_element(sample.begin(), pivot, sample.end());
    const std::size_t below = split(spheres, axis, *pivot);
    if (below == 0 || below == spheres.size()) break; // many are equal
    if (n < below)
      spheres = spheres.first(below);
    else
      spheres = spheres.subspan(below), n -= below;
  }
  std::nth_element(spheres.begin(), spheres.begin() + static_cast<std::ptrdiff_t>(n), spheres.end(),
                   [axis](const Added& a, const Added& b) { return a.sphere.center[axis] < b.sphere.center[axis]; });
}

// Orders the spheres so that each pack's are neighbours: the whole is split in two across its longest side, between two
// packs, then each half, and so on.
template <class Added>
void group_neighbours(std::span<Added> spheres) {
  while (spheres.size() > SpherePack::size) {
    Vec3 lower = spheres.front().sphere.center, upper = lower;
    for (const Added& a : spheres) lower = min(lower, a.sphere.center), upper = max(upper, a.sphere.center);
    const Vec3 extent = upper - lower;
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t packs = (spheres.size() + SpherePack::size - 1) / SpherePack::size;
    const std::size_t cut = packs / 2 * SpherePack::size;
    select(spheres, cut, axis);
    group_neighbours(spheres.first(cut));
    spheres = spheres.subspan(cut);
  }
}

} // namespace

void ShapeLeaves<Baked<SphereGeometry>>::arrange() {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  group_neighbours(std::span(added_));
  packs_.resize((added_.size() + SpherePack::size - 1) / SpherePack::size);
  tags_.reserve(added_.size());
  if (!packs_.empty()) packs_.back().radius.fill(nothing);
  for (std::size_t i = 0; i < added_.size(); ++i) {
    const SphereGeometry& sphere = added_[i].sphere;
    SpherePack& pack = packs_[i / SpherePack::size];
    const std::size_t lane = i % SpherePack::size;
    pack.x[lane] = sphere.center.x;
    pack.y[lane] = sphere.center.y;
    pack.z[lane] = sphere.center.z;
    pack.radius[lane] = sphere.radius;
    tags_.push_back(added_[i].tag);
  }
  added_ = {};
}

Box3 ShapeLeaves<Baked<SphereGeometry>>::bounds(std::uint32_t i) const {
  Box3 box;
  const auto rest = static_cast<std::uint32_t>(tags_.size()) - i * SpherePack::size;
  for (std::uint32_t lane = 0; lane < std::min(rest, SpherePack::size); ++lane)
    box.extend(rt::bounds(packs_[i].sphere(lane)));
  return box;
}

bool ShapeLeaves<Baked<SphereGeometry>>::inspect(std::uint32_t i, InspectQuery& query) const {
  const auto count = static_cast<std::uint32_t>(tags_.size());
  for (std::uint32_t index = i * SpherePack::size; index < std::min(count, (i + 1) * SpherePack::size); ++index) {
    const SphereGeometry sphere = packs_[i].sphere(index % SpherePack::size);
    Hit hit;
    if (query.hits)
      for (Interval rest = query.interval; intersect(sphere, query.ray, rest, hit); rest.lower = hit.t)
        query.add_hit({hit, 0, false, false}, index, leaf_kind<ShapeLeaves>, this);
    const BindingId binding = query.resolved(tags_[index].binding_id());
    if (query.around && query.bindings.is_medium(binding) && contains(sphere, query.ray.origin))
      query.add_around(tags_[index].slot, binding);
  }
  return false;
}

} // namespace rt
