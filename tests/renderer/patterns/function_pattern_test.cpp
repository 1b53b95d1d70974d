#include "renderer/functions/function_builder.hpp"
#include "renderer/patterns/function_pattern.hpp"
#include "renderer/shading/materials.hpp"

#include <catch2/catch.hpp>

#include <memory>
#include <vector>

using namespace rt;

namespace {

using Node = FunctionBuilder::Node;

scene::FunctionPattern pattern_of(FunctionBuilder& builder, std::vector<Node> results) {
  return {std::make_shared<const Function>(builder.finish(results))};
}

} // namespace

TEST_CASE("function pattern: a number is grey, three are a colour") {
  FunctionBuilder b(3);
  const Node x = b.input(0), y = b.input(1), z = b.input(2);
  CHECK(paint_at(pattern_of(b, {x}), {0.25, 2, 3}) == scene::Paint(grey(0.25)));
  CHECK(paint_at(pattern_of(b, {z, x, y}), {0.25, 2, 3}) == scene::Paint(Color{3, 0.25, 2}));
  CHECK(paint_at(scene::FunctionPattern{}, {0.25, 2, 3}) == scene::Paint(white));
}

TEST_CASE("function pattern: what is no light is 0: less than nothing, without end, or no number") {
  FunctionBuilder b(3);
  const Node x = b.input(0);
  const scene::FunctionPattern pattern =
      pattern_of(b, {x, b.apply(Opcode::divide, b.constant(1), x), b.apply(Opcode::square_root, x)});
  CHECK(paint_at(pattern, {-4, 0, 0}) == scene::Paint(black));
  CHECK(paint_at(pattern, {0, 0, 0}) == scene::Paint(black));
  CHECK(paint_at(pattern, {4, 0, 0}) == scene::Paint(Color{4, 0.25, 2}));
}

TEST_CASE("function pattern: a long function needs no more than memory") {
  FunctionBuilder b(3);
  Node sum = b.input(0);
  for (int i = 1; i <= 5000; ++i) sum = b.apply(Opcode::add, sum, b.apply(Opcode::multiply, b.input(1), b.constant(i)));
  // x + y·(1 + 2 + … + 5000)
  CHECK(paint_at(pattern_of(b, {sum}), {1, 2, 0}) == scene::Paint(grey(1 + 2 * 12'502'500.0)));
}

TEST_CASE("function pattern: a property holds what it is given within what it takes") {
  FunctionBuilder b(3);
  scene::Scene scene;
  scene.patterns.push_back({pattern_of(b, {b.input(0)}), {}});
  scene::Material m;
  m.refract = m.metallic = m.specular = m.shininess = scene::PatternId{0};
  scene.materials = {m};
  const Materials materials(scene);
  CHECK(materials.at(1, {0.5, 0, 0}).refract == 0.5);
  CHECK(materials.at(1, {7, 0, 0}).refract == 1);
  CHECK(materials.at(1, {7, 0, 0}).metallic == 1);
  CHECK(materials.at(1, {7, 0, 0}).specular == 7);
  CHECK(materials.at(1, {-7, 0, 0}).shininess > 0);
}
