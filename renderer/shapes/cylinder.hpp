#pragma once

#include "renderer/scene/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The points at `radius` from the segment `from`–`to`, and the two discs that close it; or, about the origin of the
/// shape's own space, along `axis` for `height` (half of it each way). `open` leaves out the discs; `infinite` goes on
/// along the axis both ways.
struct Cylinder {
  static constexpr std::string_view noun = "cylinder";
  static constexpr std::string_view help = "a round bar between two points, or along an axis";
  std::optional<Vec3> from, to;
  std::optional<Vec3> axis;     ///< +y where no form is written
  std::optional<double> height; ///< 1 where it is not written
  double radius = 1;
  bool open = false;
  bool infinite = false;
};

std::span<const Field> fields(const Cylinder*);
std::optional<Problem> check(const Cylinder&);

} // namespace rt::scene

namespace rt {

struct CylinderGeometry {
  enum class Extent : std::uint8_t { closed, open, infinite };
  Vec3 base; ///< the end at height 0, on the axis
  Vec3 axis; ///< unit
  double height = 1;
  double radius = 1;
  Extent extent = Extent::closed; ///< the height of what is infinite has no meaning
};

CylinderGeometry geometry(const scene::Cylinder& cylinder);
std::optional<CylinderGeometry> placed(const CylinderGeometry& cylinder, const Affine& map);
Box3 bounds(const CylinderGeometry& cylinder, const Affine& map = {});

} // namespace rt
