#include "renderer/shapes/cone.hpp"

#include "renderer/shapes/disc.hpp"

namespace rt::scene {

std::span<const Field> fields(const Cone*) {
  static constexpr Field table[] = {
      field<&Cone::from>("from", {"[0, 0, 0]", "centre of one end"}),
      field<&Cone::to>("to", {"[0, 1, 0]", "centre of the other end"}),
      field<&Cone::radius>("radius", {"1", "radius at `from`", not_negative}),
      field<&Cone::top_radius>("top_radius", {"0", "radius at `to`; 0 makes a point", not_negative}),
      field<&Cone::open>("open", {"false", "true: without the discs that close it"}),
  };
  return table;
}

std::optional<Problem> check(const Cone& cone) {
  if (cone.from == cone.to) return Problem{"to", "`from` and `to` are the same point: the cone has no length"};
  if (cone.radius == 0 && cone.top_radius == 0)
    return Problem{"radius", "`radius` and `top_radius` are both 0: the cone has no surface"};
  return std::nullopt;
}

} // namespace rt::scene

namespace rt {

ConeGeometry geometry(const scene::Cone& cone) {
  const Vec3 along = cone.to - cone.from;
  const double height = length(along);
  return {cone.from, normalize(along), height, cone.radius, cone.top_radius, (cone.top_radius - cone.radius) / height,
          cone.open};
}

std::optional<ConeGeometry> placed(const ConeGeometry& cone, const Affine& map) {
  const auto scale = similarity_scale(map);
  if (!scale) return std::nullopt;
  return ConeGeometry{map.point(cone.base),  normalize(map.vector(cone.axis)), cone.height * *scale, cone.radius * *scale,
                      cone.top_radius * *scale, cone.slope, cone.is_open};
}

Box3 bounds(const ConeGeometry& cone, const Affine& map) {
  Box3 box = disc_bounds(map, cone.base, cone.axis, cone.radius);
  box.extend(disc_bounds(map, cone.base + cone.axis * cone.height, cone.axis, cone.top_radius));
  return box;
}

} // namespace rt
