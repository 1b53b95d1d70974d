// Stripes, tiles, bricks, hexagons and dots.

#include "renderer/patterns/brick.hpp"
#include "renderer/patterns/dots.hpp"
#include "renderer/patterns/hexagon.hpp"
#include "renderer/patterns/stripes.hpp"
#include "renderer/patterns/tiles.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace rt;

namespace {

const scene::Paint a = Color{1, 0, 0}, b = Color{0, 1, 0}, c = Color{0, 0, 1};

} // namespace

TEST_CASE("stripes: the first has its width of every unit of x, whatever y and z") {
  const scene::Stripes stripes{a, b, 0.25};
  CHECK(paint_at(stripes, {0, 7, 7}) == a);
  CHECK(paint_at(stripes, {0.2, -7, 7}) == a);
  CHECK(paint_at(stripes, {0.3, 7, -7}) == b);
  CHECK(paint_at(stripes, {-0.1, 7, 7}) == b);
  CHECK(paint_at(stripes, {-0.9, 7, 7}) == a);
  CHECK(paint_at(stripes, {3 - 5e-11, 7, 7}) == a); // a surface at a whole number, and 1e-10 below
}

TEST_CASE("tiles: cubes by turns, and joints just below whole numbers, in all three directions") {
  const scene::Tiles tiles{a, b, c, 0.1};
  CHECK(paint_at(tiles, {0.5, 0.5, 0.5}) == a);
  CHECK(paint_at(tiles, {1.5, 0.5, 0.5}) == b);
  CHECK(paint_at(tiles, {-0.5, -0.5, 0.5}) == a);
  CHECK(paint_at(tiles, {0.95, 0.5, 0.5}) == c);
  CHECK(paint_at(tiles, {0.5, -0.05, 0.5}) == c);
  CHECK(paint_at(tiles, {0.5, 0.5, 1.95}) == c);
  CHECK(paint_at(tiles, {0.5, 1, 0.5}) == b); // a floor shows tiles
  CHECK(paint_at(tiles, {0.5, 0, 0.5}) == a);
}

TEST_CASE("brick: courses are moved by half a brick, and mortar lies below whole ones") {
  const scene::Brick brick{b, a, {4, 2, 3}, 0.5};
  // The first course: bricks from x = 0 to 3.5, mortar to 4; along z they are moved by half of one.
  CHECK(paint_at(brick, {0.2, 0.5, 0.2}) == a);
  CHECK(paint_at(brick, {3.4, 0.5, 0.2}) == a);
  CHECK(paint_at(brick, {3.7, 0.5, 0.2}) == b);
  CHECK(paint_at(brick, {-0.2, 0.5, 0.2}) == b);
  CHECK(paint_at(brick, {0.2, 0.5, 1.2}) == b); // from 1 to 1.5
  CHECK(paint_at(brick, {0.2, 0.5, 1.6}) == a);
  // Mortar above it, from 1.5 to 2, and the second course.
  CHECK(paint_at(brick, {0.2, 1.7, 0.2}) == b);
  CHECK(paint_at(brick, {3.7, 2.5, 0.2}) == a);
  CHECK(paint_at(brick, {1.7, 2.5, 0.2}) == b); // from 1.5 to 2
  CHECK(paint_at(brick, {0.2, 2.5, 2.7}) == b); // from 2.5 to 3
  CHECK(paint_at(brick, {0.2, -0.2, 0.2}) == b);
  CHECK(paint_at(brick, {1.7, -1, 0.2}) == b); // the course below is moved too
}

TEST_CASE("hexagon: sides of one unit, and no two neighbours in one colour") {
  const scene::Hexagon hexagon{a, b, c};
  CHECK(paint_at(hexagon, {0, 5, 0}) == a);
  CHECK(paint_at(hexagon, {0.99, -5, 0}) == a); // a corner on x
  CHECK(paint_at(hexagon, {0, 5, 0.86}) == a);  // the middle of a side: √3/2
  CHECK(paint_at(hexagon, {0, 5, 0.87}) == b);
  const double up = std::sqrt(3.0);
  CHECK(paint_at(hexagon, {0, 5, up}) == b);
  CHECK(paint_at(hexagon, {0, 5, 2 * up}) == c);
  CHECK(paint_at(hexagon, {0, 5, -up}) == c);
  // All around the first, from above counterclockwise.
  const scene::Paint around[] = {b, c, b, c, b, c};
  for (int i = 0; i < 6; ++i) {
    const double angle = (90 + 60 * i) * std::acos(-1.0) / 180;
    INFO(i);
    CHECK(paint_at(hexagon, {up * std::cos(angle), 5, up * std::sin(angle)}) == around[i]);
  }
}

TEST_CASE("dots: balls about points with whole coordinates") {
  const scene::Dots dots{a, b, 0.3};
  CHECK(paint_at(dots, {0, 0, 0}) == b);
  CHECK(paint_at(dots, {-3, 2.29, 7}) == b);
  CHECK(paint_at(dots, {-3, 2.31, 7}) == a);
  CHECK(paint_at(dots, {0.2, 0.2, 0.2}) == a); // √0.12 = 0.346
  CHECK(paint_at(dots, {0.5, 0.5, 0.5}) == a);
}
