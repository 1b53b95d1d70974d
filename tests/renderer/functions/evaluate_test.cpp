#include "renderer/functions/evaluate.hpp"
#include "tests/renderer/functions/random_function.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>

namespace rt::tests {
namespace {

using Node = FunctionBuilder::Node;

double value_of(Opcode operation, double a, double b = 0, double c = 0) {
  FunctionBuilder builder(3);
  const Node results[] = {builder.apply(operation, builder.input(0), builder.input(1), builder.input(2))};
  const Function f = builder.finish(results);
  std::vector<double> registers(f.register_count());
  const double inputs[] = {a, b, c};
  evaluate(f, inputs, registers);
  return registers[f.results[0]];
}

} // namespace

TEST_CASE("functions: each operation has its value") {
  using enum Opcode;
  CHECK(value_of(negate, 2) == -2);
  CHECK(value_of(absolute, -2) == 2);
  CHECK(value_of(Opcode::floor, -1.5) == -2);
  CHECK(value_of(Opcode::ceil, -1.5) == -1);
  CHECK(value_of(Opcode::round, -1.5) == -2);
  CHECK(value_of(Opcode::round, 2.5) == 3);
  CHECK(value_of(square_root, 2.25) == 1.5);
  CHECK(value_of(sine, 30) == 0.5);
  CHECK(value_of(cosine, 60) == 0.5);
  CHECK(value_of(tangent, 45) == 1);
  CHECK(value_of(arc_sine, 1 + 1e-13) == 90);
  CHECK(value_of(arc_cosine, -1) == 180);
  CHECK(value_of(arc_tangent, -1) == -45);
  CHECK(value_of(exponential, 0) == 1);
  CHECK(value_of(logarithm, 1) == 0);
  CHECK(value_of(logarithm2, 8) == 3);
  CHECK(value_of(logarithm10, 1000) == 3);
  CHECK(value_of(not_, 0) == 1);
  CHECK(value_of(not_, 1) == 0);
  CHECK(value_of(add, 1, 2) == 3);
  CHECK(value_of(subtract, 1, 2) == -1);
  CHECK(value_of(multiply, 3, 2) == 6);
  CHECK(value_of(divide, 3, 2) == 1.5);
  CHECK(value_of(modulo, -1, 3) == 2);
  CHECK(value_of(modulo, 1, -3) == -2);
  CHECK(value_of(power, 2, -1) == 0.5);
  CHECK(value_of(minimum, 1, 2) == 1);
  CHECK(value_of(maximum, 1, 2) == 2);
  CHECK(value_of(arc_tangent2, 1, -1) == 135);
  CHECK(value_of(hypotenuse, 3, 4) == 5);
  CHECK(value_of(Opcode::less, 1, 1) == 0);
  CHECK(value_of(Opcode::less_equal, 1, 1) == 1);
  CHECK(value_of(equal, 1, 1) == 1);
  CHECK(value_of(and_, 1, 0) == 0);
  CHECK(value_of(or_, 1, 0) == 1);
  CHECK(value_of(select, 1, 2, 3) == 2);
  CHECK(value_of(select, 0, 2, 3) == 3);
}

TEST_CASE("functions: what has no value is not a number, and compares to nothing") {
  using enum Opcode;
  CHECK(std::isnan(value_of(square_root, -1)));
  CHECK(std::isnan(value_of(logarithm, -1)));
  CHECK(std::isnan(value_of(arc_sine, 1.1)));
  CHECK(std::isnan(value_of(modulo, 1, 0)));
  CHECK(value_of(Opcode::less, std::nan(""), 1) == 0);
  CHECK(value_of(select, value_of(equal, std::nan(""), std::nan("")), 1, 2) == 2);
}

TEST_CASE("functions: eight points at a time have the values of each, to the last bit") {
  SplitMix64 random(7);
  std::size_t undefined = 0;
  for (int i = 0; i < 2000; ++i) {
    const Function f = random_function(random, 1 + i % 60);
    std::array<Batch, 3> points;
    for (Batch& axis : points)
      for (double& x : axis.lane) x = random.between(-5, 5);
    std::vector<Batch> registers(f.register_count());
    evaluate(f, points, registers);
    std::vector<double> single(f.register_count(), 123.0); // what was there before does not matter
    for (std::size_t k = 0; k < Batch::size; ++k) {
      const double point[] = {points[0].lane[k], points[1].lane[k], points[2].lane[k]};
      evaluate(f, point, single);
      for (const Register r : f.results) {
        const double together = registers[r].lane[k];
        undefined += std::isnan(single[r]) ? 1 : 0;
        if (std::isnan(single[r]))
          REQUIRE(std::isnan(together));
        else
          REQUIRE(std::bit_cast<std::uint64_t>(together) == std::bit_cast<std::uint64_t>(single[r]));
      }
    }
  }
  CHECK(undefined < 24'000); // of 48,000
}

} // namespace rt::tests
