#pragma once

#include "renderer/fields/type_list.hpp"
#include "renderer/patterns/checker.hpp"
#include "renderer/patterns/function_pattern.hpp"
#include "renderer/scene/transform.hpp"

namespace rt::scene {

/// All patterns. A new pattern is added here, and its header above.
using PatternKinds = TypeList<Checker, FunctionPattern>;
using PatternLayout = PatternKinds::Variant;

/// Colours or numbers as a function of position, in the space of the object that specifies `material:`, before that
/// object's own transform; `placement` places the pattern there.
struct Pattern {
  PatternLayout layout;
  Placement placement;
};

} // namespace rt::scene
