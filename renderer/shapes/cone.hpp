#pragma once

#include "renderer/scene/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The surface swept by a circle whose radius goes from `radius` at `from` to `top_radius` at `to` (0: a point), closed by
/// a disc at each end whose radius is not 0; `open` leaves the discs out.
struct Cone {
  static constexpr std::string_view noun = "cone";
  static constexpr std::string_view help = "a round bar whose radius changes from end to end";
  Vec3 from{0, 0, 0};
  Vec3 to{0, 1, 0};
  double radius = 1;
  double top_radius = 0;
  bool open = false;
};

std::span<const Field> fields(const Cone*);
std::optional<Problem> check(const Cone&);

} // namespace rt::scene

namespace rt {

/// At height z above `base`, 0 ≤ z ≤ height, the radius is radius + slope·z.
struct ConeGeometry {
  Vec3 base;
  Vec3 axis; ///< unit
  double height = 1;
  double radius = 1;
  double top_radius = 0;
  double slope = -1; ///< (top_radius − radius) / height
  bool is_open = false;
};

ConeGeometry geometry(const scene::Cone& cone);
std::optional<ConeGeometry> placed(const ConeGeometry& cone, const Affine& map);
Box3 bounds(const ConeGeometry& cone, const Affine& map = {});

} // namespace rt
