#pragma once

#include "renderer/scene/material.hpp"
#include "renderer/scene/transform.hpp"

namespace rt::scene {

/// A shape in `Shapes`: its kind, and its index among the shapes of that kind. Two objects with equal references share
/// the shape: if it is a group, they are instances.
struct ShapeRef {
  std::uint32_t kind = 0;
  std::uint32_t index = 0;
  friend bool operator==(const ShapeRef&, const ShapeRef&) = default;
};

/// Index into `Scene::names`.
enum class NameId : std::uint32_t {};
inline constexpr NameId no_name{0xffffffff};

/// Where something was written: an index into `Scene::files` and a line, from 1 (0: not written but assumed).
struct Origin {
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  friend bool operator==(const Origin&, const Origin&) = default;
};

/// A shape placed in its parent's space (the scene's, a group's or a combination's). Its placement is that of
/// `Scene::turns[turn]` with this `at`.
struct Object {
  Vec3 at{};
  ShapeRef shape;
  TransformId transform = no_transform;
  MaterialId material = no_material;
  NameId name = no_name;
  Origin origin{};
  bool is_visible = true;
  bool casts_shadow = true;
};

} // namespace rt::scene
