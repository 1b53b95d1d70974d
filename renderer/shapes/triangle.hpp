#pragma once

#include "renderer/scene/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// A triangle with its edges. `normals`, one for each corner or none at all, are interpolated over it to make it look
/// curved: each is carried to the scene and normalised before the interpolation.
struct Triangle {
  static constexpr std::string_view noun = "triangle";
  static constexpr std::string_view help = "a flat face with three corners, or one that looks curved";
  std::array<Vec3, 3> points{Vec3{-0.5, 0, 0}, Vec3{0.5, 0, 0}, Vec3{0, 1, 0}};
  std::vector<Vec3> normals;
};

std::span<const Field> fields(const Triangle*);
std::optional<Problem> check(const Triangle&);

} // namespace rt::scene

namespace rt {

struct TriangleGeometry {
  std::array<Vec3, 3> points;
};

TriangleGeometry geometry(const scene::Triangle& triangle);
std::optional<TriangleGeometry> placed(const TriangleGeometry& triangle, const Affine& map);
Box3 bounds(const TriangleGeometry& triangle, const Affine& map = {});

} // namespace rt
