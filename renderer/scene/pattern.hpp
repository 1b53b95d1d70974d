#pragma once

#include "renderer/fields/type_list.hpp"
#include "renderer/patterns/brick.hpp"
#include "renderer/patterns/chance/agate.hpp"
#include "renderer/patterns/chance/crackle.hpp"
#include "renderer/patterns/chance/granite.hpp"
#include "renderer/patterns/chance/marble.hpp"
#include "renderer/patterns/chance/noise.hpp"
#include "renderer/patterns/chance/ripples.hpp"
#include "renderer/patterns/chance/turbulence.hpp"
#include "renderer/patterns/chance/wood.hpp"
#include "renderer/patterns/checker.hpp"
#include "renderer/patterns/dots.hpp"
#include "renderer/patterns/function_pattern.hpp"
#include "renderer/patterns/graded/cells.hpp"
#include "renderer/patterns/graded/gradient.hpp"
#include "renderer/patterns/graded/leopard.hpp"
#include "renderer/patterns/graded/onion.hpp"
#include "renderer/patterns/graded/rings.hpp"
#include "renderer/patterns/graded/spiral.hpp"
#include "renderer/patterns/hexagon.hpp"
#include "renderer/patterns/stripes.hpp"
#include "renderer/patterns/tiles.hpp"
#include "renderer/scene/transform.hpp"

namespace rt::scene {

/// All patterns. A new pattern is added here, and its header above.
using PatternKinds =
    TypeList<Checker, Stripes, Tiles, Brick, Hexagon, Dots, Gradient, Onion, Rings, Spiral, Leopard, Cells, Noise,
             Turbulence, Granite, Marble, Wood, Agate, Crackle, Ripples, FunctionPattern>;
using PatternLayout = PatternKinds::Variant;

/// Paints laid out over space. They live in the space of the object that writes `material:`, before that object's own
/// transform; `placement` moves them there.
struct Pattern {
  PatternLayout layout;
  Placement placement;
};

} // namespace rt::scene
