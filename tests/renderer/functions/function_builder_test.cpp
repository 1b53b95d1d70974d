#include "renderer/functions/function_builder.hpp"
#include "tests/renderer/functions/random_function.hpp"

#include <catch2/catch.hpp>

#include <limits>

namespace rt::tests {

using Lines = std::vector<std::string>;
using Node = FunctionBuilder::Node;

TEST_CASE("functions: what is the same is computed once") {
  FunctionBuilder b(2);
  const Node square = b.apply(Opcode::multiply, b.input(0), b.input(0));
  const Node again = b.apply(Opcode::multiply, b.input(0), b.input(0));
  CHECK(square == again);
  const Node results[] = {b.apply(Opcode::add, square, again)};
  CHECK(listing(b.finish(results)) == Lines{"t1 = x * x", "t2 = t1 + t1", "t2"});
}

TEST_CASE("functions: what is constant is computed at once, but for what has no value or is infinite") {
  FunctionBuilder b(1);
  const Node half = b.apply(Opcode::sine, b.constant(30));
  CHECK(b.constant_value(half) == 0.5);
  CHECK(b.size() == 0);
  CHECK_FALSE(b.constant_value(b.apply(Opcode::square_root, b.constant(-1))));
  CHECK_FALSE(b.constant_value(b.apply(Opcode::divide, b.constant(1), b.constant(0))));
  CHECK(b.size() == 2);
}

TEST_CASE("functions: what no result needs is left out, and so are its constants") {
  FunctionBuilder b(3);
  b.apply(Opcode::add, b.input(0), b.constant(7));
  const Node needed = b.apply(Opcode::subtract, b.input(2), b.constant(3));
  b.apply(Opcode::cosine, needed);
  const Node results[] = {needed, b.input(1), b.constant(0.25)};
  const Function f = b.finish(results);
  CHECK(listing(f) == Lines{"t1 = z - 3", "[t1, y, 0.25]"});
  CHECK(f.constants == std::vector<double>{3, 0.25});
  CHECK(is_well_formed(f));
}

TEST_CASE("functions: only what changes no bit is simplified") {
  FunctionBuilder b(2);
  const Node x = b.input(0), y = b.input(1), zero = b.constant(0), one = b.constant(1);
  CHECK(b.apply(Opcode::multiply, x, one) == x);
  CHECK(b.apply(Opcode::multiply, one, x) == x);
  CHECK(b.apply(Opcode::divide, x, one) == x);
  CHECK(b.apply(Opcode::subtract, x, zero) == x);
  CHECK(b.apply(Opcode::add, x, zero) != x);                  // of −0 it is +0
  CHECK(b.apply(Opcode::subtract, x, b.constant(-0.0)) != x); // the same
  CHECK(b.apply(Opcode::multiply, x, zero) != zero);          // of infinity it has no value
  CHECK(b.apply(Opcode::select, one, x, y) == x);
  CHECK(b.apply(Opcode::select, zero, x, y) == y);
  CHECK(b.apply(Opcode::select, x, y, y) == y);
}

TEST_CASE("functions: one that reads what is not there yet, or is not finite, is not well formed") {
  FunctionBuilder b(1);
  const Node results[] = {b.apply(Opcode::add, b.apply(Opcode::sine, b.input(0)), b.constant(2))};
  const Function good = b.finish(results);
  REQUIRE(is_well_formed(good));
  Function bad = good;
  bad.code[0].a = bad.first_instruction(); // itself
  CHECK_FALSE(is_well_formed(bad));
  bad = good;
  bad.results[0] = static_cast<Register>(bad.register_count());
  CHECK_FALSE(is_well_formed(bad));
  bad = good;
  bad.results.resize(2);
  CHECK_FALSE(is_well_formed(bad));
  bad = good;
  bad.constants[0] = std::numeric_limits<double>::infinity();
  CHECK_FALSE(is_well_formed(bad));
  bad = good;
  bad.code[0].operation = Opcode::noise; // without a seed
  CHECK_FALSE(is_well_formed(bad));
  bad = good;
  bad.input_count = 0;
  CHECK_FALSE(is_well_formed(bad));
}

TEST_CASE("functions: random ones are well formed") {
  SplitMix64 random(1);
  for (int i = 0; i < 1000; ++i) CHECK(is_well_formed(random_function(random, 40)));
}

} // namespace rt::tests
