#pragma once

#include "renderer/scene/scene.hpp"

#include <functional>
#include <string_view>

namespace rt::tools {

/// The scene's description as JSON, in pieces: numbers with enough digits to identify them, the same bytes for the same
/// scene. What is not finite is a string ("inf"). Each object is on a line of its own.
void write_scene_json(const scene::Scene& scene, const std::function<void(std::string_view)>& write);

} // namespace rt::tools
