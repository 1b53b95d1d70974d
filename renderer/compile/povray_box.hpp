#pragma once

#include "renderer/shapes/box.hpp"

namespace rt {

/// A box as POV-Ray 3.7 intersects it (measured: `tests/oracle/facts_test.cpp`). It clips the ray by x, y and z in this
/// order. Planes that the ray crosses within 1e-6 of one another count as one crossing: at the one found first, on the
/// face along whose axis the ray is steeper. So near an edge the face is not always the one that is hit, and the
/// distance is up to 1e-6 off. Rays are in scene space, with unit directions.
///
/// Before that it tests the bounding box, in 32 bits, and may miss a box when the ray only clips a corner. A part of a
/// combination has no bounding box here: POV-Ray's is that of the whole.
struct PovrayBoxGeometry {
  BoxGeometry box;
  Affine to_scene{}, to_box{};          ///< between object and scene space, once it is placed
  Vec3 bounds_lower{}, bounds_extent{}; ///< in scene space, rounded to 32 bits
};

std::optional<PovrayBoxGeometry> placed(const PovrayBoxGeometry& box, const Affine& map);
Box3 bounds(const PovrayBoxGeometry& box, const Affine& map = {});

bool intersect(const PovrayBoxGeometry& box, const Ray& ray, const Interval& range, Hit& hit);
SurfacePoint surface_point(const PovrayBoxGeometry& box, const Ray& ray, const Hit& hit);
Crossings crossings(const PovrayBoxGeometry& box, const Ray& ray);
bool contains(const PovrayBoxGeometry& box, const Vec3& point);
constexpr bool is_solid(const PovrayBoxGeometry&) {
  return true;
}

} // namespace rt
