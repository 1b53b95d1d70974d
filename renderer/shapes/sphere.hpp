#pragma once

#include "renderer/scene/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// The points at `radius` from the origin of the shape's own space (its `at` is part of the placement).
struct Sphere {
  static constexpr std::string_view noun = "sphere";
  static constexpr std::string_view help = "a ball about its middle";
  double radius = 1;
};

std::span<const Field> fields(const Sphere*);
std::optional<Problem> check(const Sphere&);

} // namespace rt::scene

namespace rt {

struct SphereGeometry {
  Vec3 center;
  double radius = 1;
};

SphereGeometry geometry(const scene::Sphere& sphere);
std::optional<SphereGeometry> placed(const SphereGeometry& sphere, const Affine& map);
Box3 bounds(const SphereGeometry& sphere, const Affine& map = {});

} // namespace rt
