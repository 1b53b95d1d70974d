#pragma once

#include "renderer/shapes/hit.hpp"

#include <span>

namespace rt {

struct Parallelogram {
  Vec3 corner, edge_u, edge_v;
  Vec3 normal; ///< unit
};

/// The outline itself if it is a parallelogram (to 1e-12 of its size); else a bounding rectangle in its plane, along
/// its first edge.
Parallelogram parallelogram_around(std::span<const Vec3> outline, const Vec3& normal);

double area(const Parallelogram& face);
AreaPoint point_by_area(const Parallelogram& face, double u, double v);

} // namespace rt
