#include "renderer/compile/povray_box.hpp"

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

constexpr double same_crossing = 1e-6, parallel = 1e-10;
constexpr double infinity = std::numeric_limits<double>::infinity();

class PovraySpan {
public:
  PovraySpan(const BoxGeometry& box, const Ray& ray) : ray_(ray) {
    is_met = clip(0, box) && clip(1, box) && clip(2, box);
  }

  Hit enter{-infinity, 0}, leave{infinity, 0};
  bool is_met;

private:
  bool clip(std::uint32_t axis, const BoxGeometry& box) {
    const double start = ray_.origin[axis], direction = ray_.direction[axis];
    if (std::abs(direction) <= parallel) return start >= box.lower[axis] && start <= box.upper[axis];
    const std::uint32_t backward = direction < 0 ? 1 : 0;
    const double lower = (box.lower[axis] - start) / direction, upper = (box.upper[axis] - start) / direction;
    const Hit first{backward != 0 ? upper : lower, 2 * axis + backward};
    const Hit last{backward != 0 ? lower : upper, 2 * axis + 1 - backward};

    if (last.t < enter.t) return false;
    if (last.t <= leave.t - same_crossing)
      leave = last;
    else if (last.t <= leave.t + same_crossing && is_steeper(last, leave))
      leave.part = last.part;
    if (first.t >= enter.t + same_crossing) {
      if (first.t > leave.t) return false;
      enter = first;
    } else if (first.t >= enter.t - same_crossing && is_steeper(first, enter)) {
      enter.part = first.part;
    }
    return true;
  }

  bool is_steeper(const Hit& a, const Hit& b) const {
    return std::abs(ray_.direction[a.part / 2]) > std::abs(ray_.direction[b.part / 2]);
  }

  const Ray& ray_;
};

Vec3 rounded(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// The ray and the box are in 32 bits, and so are products; only the final sum is not.
bool meets_bounds(const PovrayBoxGeometry& box, const Ray& ray) {
  double enter = -infinity, leave = infinity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto start = static_cast<float>(ray.origin[axis]), lower = static_cast<float>(box.bounds_lower[axis]);
    const auto extent = static_cast<float>(box.bounds_extent[axis]);
    if (ray.direction[axis] == 0) {
      if (start < lower || start > lower + extent) return false;
      continue;
    }
    const auto inverse = static_cast<float>(1 / ray.direction[axis]);
    const float to_lower = (lower - start) * inverse, across = extent * inverse;
    const double to_upper = static_cast<double>(to_lower) + across;
    enter = std::max(enter, std::min<double>(to_lower, to_upper));
    leave = std::min(leave, std::max<double>(to_lower, to_upper));
  }
  return enter <= leave && leave >= parallel;
}

} // namespace

// POV-Ray moves and scales a box's corners, and stores a matrix from the first other transform on.
std::optional<PovrayBoxGeometry> placed(const PovrayBoxGeometry& box, const Affine& map) {
  if (const std::optional<BoxGeometry> here = placed(box.box, map))
    return PovrayBoxGeometry{*here, {}, {}, rounded(here->lower), rounded(here->upper - here->lower)};
  const std::optional<Affine> to_box = inverse(map);
  if (!to_box) return std::nullopt;
  const Vec3 lower = rounded(box.box.lower), extent = rounded(box.box.upper - box.box.lower);
  const Box3 around = transform_box(map, {lower, lower + extent});
  return PovrayBoxGeometry{box.box, map, *to_box, rounded(around.lower), rounded(around.extent())};
}

Box3 bounds(const PovrayBoxGeometry& box, const Affine& map) {
  constexpr Vec3 beyond{2 * same_crossing, 2 * same_crossing, 2 * same_crossing};
  const Box3 exact = bounds(box.box, map * box.to_scene);
  return {exact.lower - beyond, exact.upper + beyond};
}

bool intersect(const PovrayBoxGeometry& box, const Ray& ray, const Interval& range, Hit& hit) {
  if (!meets_bounds(box, ray)) return false;
  const Ray carried = box.to_box.ray(ray);
  const PovraySpan span(box.box, carried);
  return span.is_met && take_first(span.enter, span.leave, range, hit);
}

SurfacePoint surface_point(const PovrayBoxGeometry& box, const Ray& ray, const Hit& hit) {
  Vec3 normal;
  normal[hit.part / 2] = hit.part % 2 == 1 ? 1 : -1;
  return {ray.at(hit.t), normalize(box.to_scene.normal(normal)), same_crossing};
}

Crossings crossings(const PovrayBoxGeometry& box, const Ray& ray) {
  const Ray carried = box.to_box.ray(ray);
  const PovraySpan span(box.box, carried);
  Crossings found;
  if (span.is_met && span.enter.t < span.leave.t) found.add(span.enter, span.leave);
  return found;
}

bool contains(const PovrayBoxGeometry& box, const Vec3& point) {
  return contains(box.box, box.to_box.point(point));
}

} // namespace rt
