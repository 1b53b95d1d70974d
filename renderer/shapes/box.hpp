#pragma once

#include "renderer/scene/field.hpp"
#include "renderer/shapes/hit.hpp"

namespace rt::scene {

/// A solid with faces perpendicular to the axes: `size` about the origin of the shape's own space, or between the opposite
/// corners `from` and `to`.
struct Box {
  static constexpr std::string_view noun = "box";
  static constexpr std::string_view help = "a block with faces along the axes";
  std::optional<Vec3> size; ///< 1 each way where no form is written
  std::optional<Vec3> from, to;
};

std::span<const Field> fields(const Box*);
std::optional<Problem> check(const Box&);

} // namespace rt::scene

namespace rt {

struct BoxGeometry {
  Vec3 lower, upper;
};

BoxGeometry geometry(const scene::Box& box);
std::optional<BoxGeometry> placed(const BoxGeometry& box, const Affine& map);
Box3 bounds(const BoxGeometry& box, const Affine& map = {});

} // namespace rt
