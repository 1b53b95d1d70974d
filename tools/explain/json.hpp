#pragma once

#include "renderer/math/color.hpp"
#include "renderer/math/vec3.hpp"
#include "renderer/scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <span>

/// What the JSON answers share.
namespace rt::tools::explain {

inline nlohmann::ordered_json to_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}
inline nlohmann::ordered_json to_json(const Color& c) {
  return {c.r, c.g, c.b};
}

/// Null for infinity, which JSON does not have: the distance of a sun.
inline nlohmann::ordered_json to_json(double v) {
  return std::isfinite(v) ? nlohmann::ordered_json(v) : nlohmann::ordered_json(nullptr);
}

/// `named` with `file` and `line` added, if known.
nlohmann::ordered_json with_place(const scene::Scene& scene, nlohmann::ordered_json named, scene::Origin origin);

/// The objects that a path leads through (`HitReport::path`): shape, name and place of each.
nlohmann::ordered_json objects_json(const scene::Scene& scene, std::span<const std::uint32_t> path);

} // namespace rt::tools::explain
