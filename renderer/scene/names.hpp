#pragma once

#include "renderer/scene/light.hpp"
#include "renderer/scene/pattern.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/shapes.hpp"

#include <string_view>

/// The names of things, and the language's names for their kinds when a kind is known only at run time.
namespace rt::scene {

/// The name of an object or a light; "" for `no_name`.
std::string_view name(const Scene& scene, NameId id);

/// "combination" for a combination; `noun(Combination::Operation)` says which.
std::string_view noun(const Shapes& shapes, ShapeRef shape);
/// "union", "intersection" or "difference".
std::string_view noun(Combination::Operation operation);
std::string_view noun(const LightSource& light);
std::string_view noun(const PatternLayout& pattern);
std::string_view noun(const Step& step);
std::string_view name(Fade::Law law);

} // namespace rt::scene
