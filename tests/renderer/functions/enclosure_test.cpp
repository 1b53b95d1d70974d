#include "renderer/functions/enclosure.hpp"
#include "tests/renderer/functions/random_function.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace rt::tests {
namespace {

using Node = FunctionBuilder::Node;
constexpr double infinity = Enclosure::infinity;

Enclosure enclosure_of(Opcode operation, const Enclosure& a, const Enclosure& b = Enclosure::of(0),
                       const Enclosure& c = Enclosure::of(0)) {
  FunctionBuilder builder(3);
  const Node results[] = {builder.apply(operation, builder.input(0), builder.input(1), builder.input(2))};
  const Function f = builder.finish(results);
  std::vector<Enclosure> registers(f.register_count());
  const Enclosure inputs[] = {a, b, c};
  evaluate(f, inputs, registers);
  return registers[f.results[0]];
}

Enclosure from(double lower, double upper) {
  return {lower, upper, false};
}

/// Holds [lower, upper], and is at most `slack` wider at each end.
void check_tight(const Enclosure& e, double lower, double upper, double slack = 1e-12) {
  CHECK_FALSE(e.may_be_undefined);
  CHECK(e.lower <= lower);
  CHECK(e.lower >= lower - slack);
  CHECK(e.upper >= upper);
  CHECK(e.upper <= upper + slack);
}

/// Boxes of all sizes, some of them flat, some with whole corners.
Enclosure random_interval(SplitMix64& random) {
  const double middle = random.between(-6, 6), reach = random.unit() < 0.1 ? 0 : std::pow(10, random.between(-6, 1));
  if (random.unit() < 0.2) return from(std::floor(middle), std::floor(middle) + std::ceil(reach));
  return from(middle - reach, middle + reach);
}

} // namespace

TEST_CASE("functions: enclosures hold a million random values") {
  SplitMix64 random(42);
  std::size_t held = 0, bounded = 0, defined = 0, total = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Function f = random_function(random, 1 + i % 25);
    const Enclosure box[] = {random_interval(random), random_interval(random), random_interval(random)};
    std::vector<Enclosure> enclosures(f.register_count());
    evaluate(f, box, enclosures);
    std::vector<double> values(f.register_count());
    for (int k = 0; k < 100; ++k) {
      double point[3];
      for (std::size_t axis = 0; axis < 3; ++axis)
        point[axis] = std::clamp(k < 2 ? (k == 0 ? box[axis].lower : box[axis].upper)
                                       : random.between(box[axis].lower, box[axis].upper),
                                 box[axis].lower, box[axis].upper);
      evaluate(f, point, values);
      for (std::size_t r = 0; r < values.size(); ++r) { // of every step
        const Enclosure& e = enclosures[r];
        const bool is_held = std::isnan(values[r]) ? e.may_be_undefined : e.contains(values[r]);
        if (!is_held) {
          for (const std::string& line : listing(f)) UNSCOPED_INFO(line);
          INFO("register " << r - f.first_instruction() + 1 << ": " << values[r] << " in " << e.lower << " to "
                           << e.upper);
          REQUIRE(is_held);
        }
      }
      ++held;
    }
    for (const Enclosure& e : enclosures) {
      CHECK_FALSE(std::isnan(e.lower));
      CHECK_FALSE(std::isnan(e.upper));
      ++total;
      bounded += std::isfinite(e.lower) && std::isfinite(e.upper) ? 1 : 0;
      defined += e.may_be_undefined ? 0 : 1;
    }
  }
  CHECK(held == 1'000'000);
  CHECK(bounded > total / 2); // they say something
  CHECK(defined > total / 2);
}

TEST_CASE("functions: enclosures are tight where a function is monotone") {
  using enum Opcode;
  check_tight(enclosure_of(negate, from(1, 2)), -2, -1, 0);
  check_tight(enclosure_of(absolute, from(-3, 2)), 0, 3, 0);
  check_tight(enclosure_of(Opcode::floor, from(-1.5, 2.5)), -2, 2, 0);
  check_tight(enclosure_of(square_root, from(0, 4)), 0, 2);
  check_tight(enclosure_of(sine, from(0, 30)), 0, 0.5);
  check_tight(enclosure_of(sine, from(30, 150)), 0.5, 1);
  check_tight(enclosure_of(sine, from(200, 300)), -1, std::sin(200 * std::acos(-1.0) / 180));
  check_tight(enclosure_of(cosine, from(-60, 90)), 0, 1);
  check_tight(enclosure_of(cosine, from(-3e6 * 360 + 10, -3e6 * 360 + 60)), 0.5, std::cos(std::acos(-1.0) / 18));
  check_tight(enclosure_of(tangent, from(-45, 45)), -1, 1);
  check_tight(enclosure_of(arc_sine, from(-1, 0.5)), -90, 30, 2e-12);
  check_tight(enclosure_of(arc_cosine, from(-1, 0.5)), 60, 180, 2e-12);
  check_tight(enclosure_of(arc_tangent, from(0, 1)), 0, 45, 2e-12);
  check_tight(enclosure_of(exponential, from(0, 1)), 1, std::exp(1.0));
  check_tight(enclosure_of(logarithm10, from(1, 1000)), 0, 3);
  check_tight(enclosure_of(add, from(1, 2), from(-3, 4)), -2, 6);
  check_tight(enclosure_of(subtract, from(1, 2), from(-3, 4)), -3, 5);
  check_tight(enclosure_of(multiply, from(-1, 2), from(-3, 4)), -6, 8);
  check_tight(enclosure_of(divide, from(1, 2), from(-4, -2)), -1, -0.25);
  check_tight(enclosure_of(modulo, from(7.25, 7.5), Enclosure::of(2)), 1.25, 1.5);
  check_tight(enclosure_of(modulo, from(7, 9), Enclosure::of(2)), 0, 2);
  check_tight(enclosure_of(power, from(-2, 3), Enclosure::of(2)), 0, 9);
  check_tight(enclosure_of(power, from(-2, 3), Enclosure::of(3)), -8, 27);
  check_tight(enclosure_of(power, from(2, 4), Enclosure::of(-1)), 0.25, 0.5);
  check_tight(enclosure_of(power, from(0.25, 4), from(-1, 0.5)), 0.25, 4);
  check_tight(enclosure_of(minimum, from(1, 5), from(2, 3)), 1, 3, 0);
  check_tight(enclosure_of(maximum, from(1, 5), from(2, 3)), 2, 5, 0);
  check_tight(enclosure_of(arc_tangent2, from(1, 2), from(-1, 1)), 45, 135, 2e-12);
  check_tight(enclosure_of(hypotenuse, from(-3, 1), from(-4, 4)), 0, 5);
  CHECK(enclosure_of(Opcode::less, from(1, 2), from(3, 4)) == Enclosure::of(1));
  CHECK(enclosure_of(Opcode::less, from(3, 4), from(1, 3)) == Enclosure::of(0));
  CHECK(enclosure_of(Opcode::less, from(1, 3), from(2, 4)) == from(0, 1));
  CHECK(enclosure_of(select, from(0, 1), from(2, 3), from(5, 6)) == from(2, 6));
  CHECK(enclosure_of(select, Enclosure::of(1), from(2, 3), from(5, 6)) == from(2, 3));
}

TEST_CASE("functions: the square of what may have either sign is not negative") {
  FunctionBuilder b(1);
  const Node square = b.apply(Opcode::multiply, b.input(0), b.input(0));
  const Node results[] = {b.apply(Opcode::square_root, square)};
  const Function f = b.finish(results);
  std::vector<Enclosure> registers(f.register_count());
  const Enclosure inputs[] = {from(-3, 2)};
  evaluate(f, inputs, registers);
  check_tight(registers[f.results[0]], 0, 3);
}

TEST_CASE("functions: division by what may be 0 has the whole line for its enclosure") {
  const Enclosure e = enclosure_of(Opcode::divide, from(1, 2), from(-1, 1));
  CHECK(e.lower == -infinity);
  CHECK(e.upper == infinity);
  CHECK_FALSE(e.may_be_undefined);
  CHECK(enclosure_of(Opcode::divide, from(0, 2), from(-1, 1)).may_be_undefined);
}

TEST_CASE("functions: an enclosure says where there may be no value, and comparisons heed it") {
  const Enclosure root = enclosure_of(Opcode::square_root, from(-1, 4));
  CHECK(root.may_be_undefined);
  CHECK(root.lower == 0);
  CHECK(root.upper == Approx(2));
  CHECK(enclosure_of(Opcode::less, root, Enclosure::of(3)) == from(0, 1)); // what has no value is not less
  CHECK(enclosure_of(Opcode::logarithm, from(0, 1)).lower == -infinity);
  CHECK(enclosure_of(Opcode::arc_sine, from(0, 1.5)).may_be_undefined);
  CHECK(enclosure_of(Opcode::sine, from(-infinity, infinity)) == Enclosure{-1, 1, true});
}

TEST_CASE("noise: its enclosure shrinks with the box") {
  FunctionBuilder b(3);
  const Node results[] = {b.noise(1, b.input(0), b.input(1), b.input(2))};
  const Function f = b.finish(results);
  std::vector<Enclosure> registers(f.register_count());
  for (const double reach : {1e-1, 1e-3, 1e-6}) {
    const Enclosure box[] = {from(0.3 - reach, 0.3 + reach), from(4 - reach, 4 + reach),
                             from(7.7 - reach, 7.7 + reach)};
    evaluate(f, box, registers);
    const Enclosure e = registers[f.results[0]];
    CHECK(e.upper - e.lower <= 2 * 3 * 6.625 * reach + 1e-11);
  }
}

} // namespace rt::tests
