#pragma once

#include "renderer/scene/scene.hpp"

#include <string>

namespace rt::tools {

/// 16 hexadecimal digits that say which scene a picture shows: those of two descriptions that differ in any value are
/// different (but for a chance of 2^-64), whatever the text they come from looked like. Names count, source lines do
/// not.
std::string scene_hash(const scene::Scene& scene);

} // namespace rt::tools
