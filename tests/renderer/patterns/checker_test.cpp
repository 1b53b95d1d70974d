#include "renderer/patterns/checker.hpp"

#include <catch2/catch.hpp>

using namespace rt;

TEST_CASE("checker: cubes of one unit by turns, beginning with the first paint") {
  const scene::Paint a = Color{1, 0, 0}, b = Color{0, 0, 1};
  const scene::Checker checker{a, b};
  CHECK(paint_at(checker, {0.5, 0.5, 0.5}) == a);
  CHECK(paint_at(checker, {1.5, 0.5, 0.5}) == b);
  CHECK(paint_at(checker, {1.5, 1.5, 0.5}) == a);
  CHECK(paint_at(checker, {1.5, 1.5, 1.5}) == b);
  CHECK(paint_at(checker, {-0.5, 0.5, 0.5}) == b);
  CHECK(paint_at(checker, {-0.5, -0.5, -0.5}) == b); // −3
  CHECK(paint_at(checker, {-0.5, -1.5, -0.5}) == a); // −4
}

TEST_CASE("checker: a surface between two cells, and 1e-10 below, is of the upper one") {
  const scene::Paint a = white, b = black;
  const scene::Checker checker{a, b};
  CHECK(paint_at(checker, {0.5, 0, 0.5}) == a);
  CHECK(paint_at(checker, {0.5, -5e-11, 0.5}) == a);
  CHECK(paint_at(checker, {0.5, -2e-10, 0.5}) == b);
}

TEST_CASE("checker: a pattern in it is left to whoever asked") {
  const scene::Paint inner = scene::PatternId{3};
  CHECK(paint_at(scene::Checker{inner, black}, {0.5, 0.5, 0.5}) == inner);
}
