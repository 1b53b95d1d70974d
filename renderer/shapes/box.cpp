#include "renderer/shapes/box.hpp"

#include "renderer/math/rounding.hpp"

#include <fmt/format.h>

namespace rt::scene {

std::span<const Field> fields(const Box*) {
  static constexpr Field table[] = {
      field<&Box::size>("size", {"1", "edge lengths along x, y and z, or one for all; the centre is at `at`", positive,
                                 1, FieldType::size}),
      field<&Box::from>("from", {"", "one corner", any_value, 2}),
      field<&Box::to>("to", {"", "the opposite corner", any_value, 2}),
  };
  return table;
}

std::optional<Problem> check(const Box& box) {
  if (box.from && !box.to) return Problem{"from", "a box with `from` needs `to`, the opposite corner"};
  if (box.to && !box.from) return Problem{"to", "a box with `to` needs `from`, the opposite corner"};
  if (!box.from) return std::nullopt;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((*box.from)[axis] == (*box.to)[axis])
      return Problem{"to",
                     fmt::format("`from` and `to` have the same {0}: the box has no size along {0}", "xyz"[axis])};
  }
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

BoxGeometry geometry(const scene::Box& box) {
  if (box.from) return {min(*box.from, *box.to), max(*box.from, *box.to)};
  const Vec3 half = box.size.value_or(Vec3{1, 1, 1}) * 0.5;
  return {-half, half};
}

std::optional<BoxGeometry> placed(const BoxGeometry& box, const Affine& map) {
  const bool keeps_axes = map.x.y == 0 && map.x.z == 0 && map.y.x == 0 && map.y.z == 0 && map.z.x == 0 && map.z.y == 0;
  if (!keeps_axes) return std::nullopt;
  const Vec3 a = map.point(box.lower), b = map.point(box.upper);
  return BoxGeometry{min(a, b), max(a, b)};
}

Box3 bounds(const BoxGeometry& box, const Affine& map) {
  return transform_box(map, {box.lower, box.upper});
}

SurfacePoint surface_point(const BoxGeometry& box, const Ray& ray, const Hit& hit) {
  const std::size_t axis = hit.part / 2;
  const bool is_upper = hit.part % 2 == 1;
  Vec3 position = max(box.lower, min(box.upper, ray.at(hit.t)));
  position[axis] = is_upper ? box.upper[axis] : box.lower[axis];
  Vec3 normal;
  normal[axis] = is_upper ? 1 : -1;
  return {position, normal, rounding_bound(8) * (magnitude(box.lower) + magnitude(box.upper))};
}

Crossings crossings(const BoxGeometry& box, const Ray& ray) {
  const BoxSpan span(box, ray);
  Crossings found;
  if (span.enter.t < span.leave.t) found.add(span.enter, span.leave);
  return found;
}

bool contains(const BoxGeometry& box, const Vec3& point) {
  return point.x > box.lower.x && point.x < box.upper.x && point.y > box.lower.y && point.y < box.upper.y &&
         point.z > box.lower.z && point.z < box.upper.z;
}

double area(const BoxGeometry& box) {
  const Vec3 size = box.upper - box.lower;
  return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

// u is divided among the six faces in proportion to their areas.
AreaPoint point_by_area(const BoxGeometry& box, double u, double v) {
  const Vec3 size = box.upper - box.lower;
  const Vec3 faces{size.y * size.z, size.z * size.x, size.x * size.y};
  double rest = u * (faces.x + faces.y + faces.z);
  std::size_t axis = 0;
  while (axis < 2 && rest >= faces[axis]) rest -= faces[axis++];
  const double within = std::min(rest / faces[axis], 1.0) * 2;
  const bool is_upper = within >= 1;
  Vec3 share;
  share[axis] = is_upper ? 1 : 0;
  share[(axis + 1) % 3] = is_upper ? within - 1 : within;
  share[(axis + 2) % 3] = v;
  Vec3 normal;
  normal[axis] = is_upper ? 1 : -1;
  return {box.lower + multiply(size, share), normal};
}

} // namespace rt
