#include "renderer/functions/evaluate.hpp"
#include "renderer/math/noise.hpp"
#include "tests/renderer/functions/random_function.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>

namespace rt::tests {
namespace {

using Node = FunctionBuilder::Node;
using Extended = long double;

Slope slope_of(Opcode operation, double a, double b = 0, double c = 0) {
  FunctionBuilder builder(3);
  const Node results[] = {builder.apply(operation, builder.input(0), builder.input(1), builder.input(2))};
  const Function f = builder.finish(results);
  std::vector<Slope> registers(f.register_count());
  const double inputs[] = {a, b, c};
  evaluate(f, inputs, registers);
  return registers[f.results[0]];
}

/// What the operation is, in numbers of 64 bits' precision, and where to try it.
struct Reference {
  Opcode operation;
  std::function<Extended(Extended, Extended)> value;
  double low, high;
};

const Extended degree = std::acos(Extended(-1)) / 180;

std::vector<Reference> references() {
  using enum Opcode;
  using X = Extended;
  return {
      {negate, [](X a, X) { return -a; }, -5, 5},
      {absolute, [](X a, X) { return std::abs(a); }, 0.1, 5},
      {absolute, [](X a, X) { return std::abs(a); }, -5, -0.1},
      {square_root, [](X a, X) { return std::sqrt(a); }, 0.1, 5},
      {sine, [](X a, X) { return std::sin(a * degree); }, -400, 400},
      {cosine, [](X a, X) { return std::cos(a * degree); }, -400, 400},
      {tangent, [](X a, X) { return std::tan(a * degree); }, -80, 80},
      {arc_sine, [](X a, X) { return std::asin(a) / degree; }, -0.9, 0.9},
      {arc_cosine, [](X a, X) { return std::acos(a) / degree; }, -0.9, 0.9},
      {arc_tangent, [](X a, X) { return std::atan(a) / degree; }, -5, 5},
      {exponential, [](X a, X) { return std::exp(a); }, -5, 5},
      {logarithm, [](X a, X) { return std::log(a); }, 0.1, 5},
      {logarithm2, [](X a, X) { return std::log2(a); }, 0.1, 5},
      {logarithm10, [](X a, X) { return std::log10(a); }, 0.1, 5},
      {add, [](X a, X b) { return a + b; }, -5, 5},
      {subtract, [](X a, X b) { return a - b; }, -5, 5},
      {multiply, [](X a, X b) { return a * b; }, -5, 5},
      {divide, [](X a, X b) { return a / b; }, 0.2, 5},
      {power, [](X a, X b) { return std::pow(a, b); }, 0.2, 3},
      {arc_tangent2, [](X a, X b) { return std::atan2(a, b) / degree; }, 0.2, 3},
      {hypotenuse, [](X a, X b) { return std::hypot(a, b); }, 0.2, 3},
  };
}

} // namespace

TEST_CASE("functions: the gradient of an operation is its difference quotient in higher precision") {
  SplitMix64 random(3);
  constexpr Extended h = 1e-6L; // the quotient's error is about h² and 1e-19 / h
  for (const Reference& reference : references()) {
    INFO(spelling(reference.operation));
    for (int i = 0; i < 1000; ++i) {
      const double a = random.between(reference.low, reference.high), b = random.between(reference.low, reference.high);
      const Slope slope = slope_of(reference.operation, a, b);
      const Extended by_a = (reference.value(a + h, b) - reference.value(a - h, b)) / (2 * h);
      const Extended by_b = (reference.value(a, b + h) - reference.value(a, b - h)) / (2 * h);
      CHECK(slope.value == Approx(static_cast<double>(reference.value(a, b))).epsilon(1e-11).margin(1e-12));
      CHECK(slope.gradient.x == Approx(static_cast<double>(by_a)).epsilon(1e-9).margin(1e-10));
      CHECK(slope.gradient.y == Approx(static_cast<double>(by_b)).epsilon(1e-9).margin(1e-10));
      CHECK(slope.gradient.z == 0);
    }
  }
}

TEST_CASE("functions: steps are flat, and choices have the gradient of what is chosen") {
  using enum Opcode;
  for (const Opcode step : {Opcode::floor, Opcode::ceil, Opcode::round, not_, Opcode::less, equal, and_})
    CHECK(slope_of(step, 0.3, 0.4).gradient == Vec3{});
  CHECK(slope_of(minimum, 1, 2).gradient == Vec3{1, 0, 0});
  CHECK(slope_of(maximum, 1, 2).gradient == Vec3{0, 1, 0});
  CHECK(slope_of(select, 1, 5, 6).gradient == Vec3{0, 1, 0});
  CHECK(slope_of(select, 0, 5, 6).gradient == Vec3{0, 0, 1});
  CHECK(slope_of(modulo, 7.5, 2).gradient == Vec3{1, -3, 0}); // 7.5 − 3·b near b = 2
}

TEST_CASE("functions: of what does not change, the gradient is 0 also where a function is infinitely steep") {
  FunctionBuilder b(2);
  const Node zero = b.apply(Opcode::multiply, b.apply(Opcode::floor, b.input(0)), b.input(0));
  const Node results[] = {b.apply(Opcode::add, b.apply(Opcode::square_root, zero), b.input(1))};
  const Function f = b.finish(results);
  std::vector<Slope> registers(f.register_count());
  const double inputs[] = {0.0, 1.0};
  evaluate(f, inputs, registers);
  CHECK(registers[f.results[0]].gradient == Vec3{0, 1, 0});
}

// ∇ of |p|·sin(x y): sin(x y) p/|p| + |p| cos(x y)·π/180·(y, x, 0).
TEST_CASE("functions: the gradient of a composition follows the chain rule") {
  FunctionBuilder b(3);
  const Node x = b.input(0), y = b.input(1), z = b.input(2);
  const auto square = [&](Node n) { return b.apply(Opcode::multiply, n, n); };
  const Node length =
      b.apply(Opcode::square_root, b.apply(Opcode::add, b.apply(Opcode::add, square(x), square(y)), square(z)));
  const Node wave = b.apply(Opcode::sine, b.apply(Opcode::multiply, x, y));
  const Node results[] = {b.apply(Opcode::multiply, length, wave)};
  const Function f = b.finish(results);
  std::vector<Slope> registers(f.register_count());
  SplitMix64 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)};
    const double inputs[] = {p.x, p.y, p.z};
    evaluate(f, inputs, registers);
    const double r = std::sqrt(dot(p, p)), angle = p.x * p.y * std::numbers::pi / 180;
    const Vec3 expected =
        p * (std::sin(angle) / r) + Vec3{p.y, p.x, 0} * (r * std::cos(angle) * std::numbers::pi / 180);
    const Vec3 found = registers[f.results[0]].gradient;
    CHECK(found.x == Approx(expected.x).epsilon(1e-12).margin(1e-13));
    CHECK(found.y == Approx(expected.y).epsilon(1e-12).margin(1e-13));
    CHECK(found.z == Approx(expected.z).epsilon(1e-12).margin(1e-13));
  }
}

TEST_CASE("noise: its gradient is its difference quotient, and no steeper than it is said to be") {
  SplitMix64 random(11);
  constexpr double h = 1e-5; // the quotient's error is about h² times the third derivative, and 1e-16 / h
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{random.between(-20, 20), random.between(-20, 20), random.between(-20, 20)};
    const auto seed = static_cast<std::uint64_t>(i % 5);
    const NoiseAndGradient found = gradient_noise_with_gradient(seed, p);
    CHECK(found.value == gradient_noise(seed, p));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3 before = p, after = p;
      before[axis] -= h, after[axis] += h;
      const double quotient =
          (gradient_noise(seed, after) - gradient_noise(seed, before)) / (after[axis] - before[axis]);
      CHECK(found.gradient[axis] == Approx(quotient).margin(2e-7));
      CHECK(std::abs(found.gradient[axis]) <= steepest_noise);
    }
  }
}

} // namespace rt::tests
