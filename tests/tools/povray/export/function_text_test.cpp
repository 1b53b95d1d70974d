#include "renderer/functions/function_builder.hpp"
#include "tools/povray/export/export_function.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace rt;
using namespace rt::tools::povray;

namespace {

using Node = FunctionBuilder::Node;

Function function_of(FunctionBuilder& builder, Node result) {
  const Node results[] = {result};
  return builder.finish(results);
}

} // namespace

TEST_CASE("export of functions: what is used once stands where it is used") {
  FunctionBuilder b(3);
  const Node product = b.apply(Opcode::multiply, b.input(0), b.constant(-2));
  const Node sine = b.apply(Opcode::sine, product);
  std::string problem;
  const auto text = function_text(function_of(b, b.apply(Opcode::maximum, sine, b.input(1))), 0, problem);
  REQUIRE(text);
  CHECK(text->declarations.empty());
  CHECK(text->expression == "max(sin((x * (-2)) * 0.017453292519943295), y)");
}

TEST_CASE("export of functions: what is used more than once is handed on from function to function") {
  FunctionBuilder b(3);
  const Node sum = b.apply(Opcode::add, b.input(0), b.input(1));
  const Node rest = b.apply(Opcode::modulo, sum, b.constant(2));
  const Node square = b.apply(Opcode::multiply, rest, rest);
  std::string problem;
  const auto text = function_text(function_of(b, b.apply(Opcode::subtract, square, sum)), 0, problem);
  REQUIRE(text);
  REQUIRE(text->declarations.size() == 2);
  CHECK(text->declarations[0].name == "f2");
  CHECK(text->declarations[0].parameters == "x, y, z, t1, t2");
  CHECK(text->declarations[0].body == "((t2 * t2) - t1)");
  CHECK(text->declarations[1].name == "f1");
  CHECK(text->declarations[1].parameters == "x, y, z, t1");
  CHECK(text->declarations[1].body == "f2(x, y, z, t1, (t1 - 2 * floor(t1 / 2)))");
  CHECK(text->expression == "f1(x, y, z, (x + y))");
}

TEST_CASE("export of functions: noise, and what has too many steps, is said to be left out") {
  FunctionBuilder b(3);
  std::string problem;
  CHECK_FALSE(function_text(function_of(b, b.noise(1, b.input(0), b.input(1), b.input(2))), 0, problem));
  CHECK(problem.starts_with("POV-Ray has another noise"));
  Node x = b.input(0);
  for (int i = 0; i < 300; ++i) x = b.apply(Opcode::add, b.apply(Opcode::multiply, x, x), b.input(1));
  CHECK_FALSE(function_text(function_of(b, x), 0, problem));
  CHECK(problem.starts_with("this function has too many steps"));
}

TEST_CASE("export of functions: the most that one gives is known where its operations say so") {
  FunctionBuilder b(3);
  CHECK(upper_bound(function_of(b, b.apply(Opcode::cosine, b.input(2))), 0) == 1);
  CHECK(upper_bound(function_of(b, b.input(2)), 0) > 1e300);
}
