#include "tests/support/asked.hpp"
#include "tests/support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace rt;

namespace {

// Panes that let half the light by and bend nothing, before a white background.
double through_panes(int panes, int max_depth) {
  tests::SceneBuilder k;
  k.scene.background = white;
  k.scene.max_depth = max_depth;
  const auto clear = k.clear(1, 0.5);
  for (int i = 0; i < panes; ++i) k.add(k.plane({0, 0, 1}, -i).with(clear));
  return tests::Asked(k).radiance({0, 0, 5}, {0, 0, -1}).r;
}

} // namespace

// POV-Ray 3.7 gives these values (max_trace_level is max_depth + 1).
TEST_CASE("depth: crossings without bending add nothing, but the deepest ray makes none") {
  CHECK(through_panes(1, 1) == 0.5);
  CHECK(through_panes(4, 1) == 0.0625);
  CHECK(through_panes(1, 0) == 0);
  CHECK(through_panes(4, 0) == 0);
}
