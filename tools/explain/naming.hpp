#pragma once

#include "renderer/scene/scene.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// How objects and lights are called in answers.
namespace rt::tools::explain {

/// The objects that a path of positions leads through, from the scene's list inwards; the last is the shape itself.
/// The path must be one of this scene's (`HitReport::path`).
std::vector<const scene::Object*> objects_on(const scene::Scene& scene, std::span<const std::uint32_t> path);

/// The object that answers for the whole of what was hit: the outermost that has a name, else the outermost
/// combination, else the shape itself. None for an empty path.
const scene::Object* owner(const scene::Scene& scene, std::span<const std::uint32_t> path);

/// Its name, or its noun where it has none; of a combination its operation.
std::string name_of(const scene::Scene& scene, const scene::Object& object);
std::string name_of(const scene::Scene& scene, const scene::Light& light);

/// `scene.rtl:12`; empty where it was not written.
std::string place_of(const scene::Scene& scene, scene::Origin origin);

/// The whole of what was hit, outermost first: "`table` (scene.rtl:12), its box (scene.rtl:4)".
std::string describe(const scene::Scene& scene, std::span<const std::uint32_t> path);
std::string describe(const scene::Scene& scene, const scene::Light& light);

/// The name of what answers for the whole.
std::string title(const scene::Scene& scene, std::span<const std::uint32_t> path);

} // namespace rt::tools::explain
