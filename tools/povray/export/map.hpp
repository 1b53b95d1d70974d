#pragma once

#include "renderer/scene/transform.hpp"

#include <array>

/// The exporter's own affine maps. They are computed here a second time, from the steps as written and in POV-Ray's
/// convention (row vectors), so that an error in the renderer's matrices cannot go unnoticed.
namespace rt::tools::povray {

/// p' = p · M: rows 0 to 2 are the images of the unit vectors, row 3 is the translation. The order of POV-Ray's
/// `matrix`.
struct Map {
  std::array<Vec3, 4> row{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, 0}};

  Vec3 point(const Vec3& p) const;
  Vec3 vector(const Vec3& v) const;
  friend bool operator==(const Map&, const Map&) = default;
};

/// First `a`, then `b`.
Map then(const Map& a, const Map& b);
/// `map` must not be singular.
Map inverse(const Map& map);

/// The unit vector in the direction of `v`.
Vec3 unit(const Vec3& v);

Map map_of(const scene::RotateAxisStep& step);
Map map_of(const scene::ShearStep& step);
Map map_of(const scene::MirrorStep& step);
Map map_of(const scene::Step& step);
Map map_of(const scene::Placement& placement);

} // namespace rt::tools::povray
