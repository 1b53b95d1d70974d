#pragma once

#include "renderer/scene/scene.hpp"

#include <string>

namespace rt::tools {

/// 16 hexadecimal digits that identify the scene of a picture: two descriptions that differ in any value have
/// different ones (except with a probability of 2^-64), whatever their source text. Names count, source lines do
/// not.
std::string scene_hash(const scene::Scene& scene);

} // namespace rt::tools
