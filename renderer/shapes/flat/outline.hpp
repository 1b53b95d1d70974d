#pragma once

#include "renderer/fields/field.hpp"
#include "renderer/math/affine.hpp"

#include <span>

namespace rt {

/// The normal of a closed polygonal chain, not normalised: twice the area it encloses, right-handed about it. Newell's
/// method (Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface Algorithms, 1974).
Vec3 newell_normal(std::span<const Vec3> points);

/// Whether all points are collinear, up to the rounding of their coordinates.
bool is_line(std::span<const Vec3> points);

/// The diagonal of the points' bounding box.
double outline_extent(std::span<const Vec3> points);

/// The bounding box of the points' images.
Box3 outline_bounds(std::span<const Vec3> points, const Affine& map);

} // namespace rt

namespace rt::scene {

/// What is wrong with `points` as the outline of a planar face: fewer than three, a repeated point, no area, not planar
/// (to 1e-9 of its size), turning back on itself, or edges that cross. Parts of it may touch, so that a seam can lead
/// to a hole. The field to blame is `points`.
std::optional<Problem> check_outline(std::span<const Vec3> points);

} // namespace rt::scene
