#include "tools/terminal/progress_bar.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using rt::tools::progress_line;

TEST_CASE("progress: the line shows share, speed and the time that is left") {
  CHECK(progress_line({}) == "[..............................]   0 %");
  // A quarter took 10 s: three more quarters take 30 s.
  CHECK(progress_line({.fraction = 0.25, .rays = 25'000'000, .seconds = 10}) ==
        "[#######.......................]  25 %  2.50 M rays/s  30 s left");
  CHECK(progress_line({.fraction = 0.999, .rays = 1000, .seconds = 999}) ==
        "[#############################.]  99 %  1.00 rays/s  1 s left");
  CHECK(progress_line({.fraction = 1, .rays = 10, .seconds = 2}) ==
        "[##############################] 100 %  5 rays/s  0 s left");
  CHECK(progress_line({.fraction = 0.5, .rays = 0, .seconds = 125}).ends_with("  2:05 min left"));
  CHECK(progress_line({.fraction = 0.5, .rays = 0, .seconds = 7260}).ends_with("  2:01 h left"));
}
