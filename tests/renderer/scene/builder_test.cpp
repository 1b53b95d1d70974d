#include "renderer/scene/builder.hpp"

#include <catch2/catch.hpp>

using namespace rt;
using namespace rt::scene;

namespace {

Object of(ShapeRef shape) {
  return {.shape = shape};
}

} // namespace

TEST_CASE("builder: materials that are equal are kept once, however they are written") {
  Builder build;
  Material red;
  red.color = Color{1, 0, 0};
  const MaterialId id = build.material(red);
  CHECK(build.material(Color{1, 0, 0}) == id);
  red.ior = 1.5;
  const MaterialId glass = build.material(red);
  CHECK(glass != id);
  CHECK(build.material(red) == glass);
  CHECK(build.scene.materials.size() == 2);
}

TEST_CASE("builder: names and transforms are kept once, and what moves nothing has none") {
  Builder build;
  CHECK(build.name("ball") == build.name("ball"));
  CHECK(build.name("box") != build.name("ball"));
  CHECK(build.scene.names == std::vector<std::string>{"ball", "box"});
  CHECK(build.transform({}) == no_transform);
  CHECK(build.transform({{1, 1, 1}, {}, {7, 8, 9}, {}}) == no_transform); // `at` is the object's
  const auto turned = build.transform({{1, 1, 1}, {0, 90, 0}, {}, {MoveStep{{1, 2, 3}}}});
  CHECK(build.transform({{1, 1, 1}, {0, 90, 0}, {4, 4, 4}, {MoveStep{{1, 2, 3}}}}) == turned);
  CHECK(build.transform({{1, 1, 1}, {0, 90, 0}, {}, {MoveStep{{1, 2, 4}}}}) != turned);
  CHECK(build.scene.transforms.size() == 2);
}

TEST_CASE("builder: a placement that flattens has no transform") {
  Builder build;
  CHECK_FALSE(build.transform({{1, 0, 1}, {}, {}, {}}));
  CHECK_FALSE(build.transform({{1e200, 1e200, 1}, {}, {}, {}})); // the determinant is beyond all numbers
  CHECK(build.scene.transforms.empty());
}

TEST_CASE("builder: a group that is combined is the union of its members, made once") {
  Builder build;
  const ShapeRef ball = build.shape(Sphere{}), pair = build.group({of(ball), of(build.group({of(ball)}))});
  const ShapeRef whole = build.combination(Combination::Operation::subtract, {of(pair), of(pair), of(ball)});
  const Combination made = build.scene.shapes.get<Combination>(whole);
  REQUIRE(made.operands.size() == 3);
  REQUIRE(made.operands[0].shape.kind == kind_of<Combination>);
  CHECK(made.operands[0].shape == made.operands[1].shape);
  CHECK(made.operands[2].shape == ball);
  const Combination united = build.scene.shapes.get<Combination>(made.operands[0].shape);
  CHECK(united.operation == Combination::Operation::unite);
  REQUIRE(united.operands.size() == 2);
  CHECK(united.operands[1].shape.kind == kind_of<Combination>); // the group within the group too
  CHECK(build.scene.shapes.get<Group>(pair).members.size() == 2);
}

TEST_CASE("builder: what keeps a shape from being a solid is found within groups") {
  Builder build;
  const ShapeRef ball = build.shape(Sphere{}), disc = build.shape(Disc{});
  CHECK(build.open_part(ball).empty());
  CHECK(build.open_part(disc) == "disc");
  const ShapeRef group = build.group({of(ball), of(build.group({of(ball), of(disc)}))});
  CHECK(build.open_part(group) == "disc");
  CHECK(build.open_part(build.group({of(ball)})).empty());
  CHECK(build.open_part(build.combination(Combination::Operation::unite, {of(ball)})).empty());
}
