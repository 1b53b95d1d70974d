#include "renderer/functions/apply.hpp"
#include "renderer/functions/evaluate.hpp"
#include "renderer/math/noise.hpp"

#include <cassert>
#include <numbers>

namespace rt {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180, degrees_per_radian = 180 / std::numbers::pi;

// What does not change stays so, however steep the function of it is: a root at 0.
Vec3 times(double slope, const Vec3& gradient) {
  const auto product = [slope](double g) { return g == 0 ? 0 : slope * g; };
  return {product(gradient.x), product(gradient.y), product(gradient.z)};
}

double square(double x) {
  return x * x;
}

// The derivative of an operation of one number by it; `value` is the operation's.
template <Opcode operation>
double derivative([[maybe_unused]] double a, [[maybe_unused]] double value) {
  using enum Opcode;
  if constexpr (operation == negate) return -1;
  if constexpr (operation == absolute) return a < 0 ? -1 : 1;
  if constexpr (operation == square_root) return 0.5 / value;
  if constexpr (operation == sine) return cos_degrees(a) * radians_per_degree;
  if constexpr (operation == cosine) return -sin_degrees(a) * radians_per_degree;
  if constexpr (operation == tangent) return radians_per_degree * (1 + square(value));
  if constexpr (operation == arc_sine) return degrees_per_radian / std::sqrt((1 - a) * (1 + a));
  if constexpr (operation == arc_cosine) return -degrees_per_radian / std::sqrt((1 - a) * (1 + a));
  if constexpr (operation == arc_tangent) return degrees_per_radian / (1 + square(a));
  if constexpr (operation == exponential) return value;
  if constexpr (operation == logarithm) return 1 / a;
  if constexpr (operation == logarithm2) return std::numbers::log2e / a;
  if constexpr (operation == logarithm10) return std::numbers::log10e / a;
  return 0; // steps
}

Vec3 power_gradient(const Slope& a, const Slope& b, double value) {
  Vec3 gradient = times(b.value * std::pow(a.value, b.value - 1), a.gradient);
  if (b.gradient != Vec3{}) gradient += times(value == 0 ? 0 : value * std::log(a.value), b.gradient);
  return gradient;
}

// Of an operation of two numbers or three.
template <Opcode operation>
Vec3 gradient_of(const Slope& a, const Slope& b, const Slope& c, [[maybe_unused]] double value) {
  using enum Opcode;
  if constexpr (operation == add) return a.gradient + b.gradient;
  if constexpr (operation == subtract) return a.gradient - b.gradient;
  if constexpr (operation == multiply) return times(b.value, a.gradient) + times(a.value, b.gradient);
  if constexpr (operation == divide) return times(1 / b.value, a.gradient) - times(value / b.value, b.gradient);
  if constexpr (operation == modulo) return a.gradient - times(std::floor(a.value / b.value), b.gradient);
  if constexpr (operation == power) return power_gradient(a, b, value);
  if constexpr (operation == minimum) return b.value < a.value ? b.gradient : a.gradient;
  if constexpr (operation == maximum) return a.value < b.value ? b.gradient : a.gradient;
  if constexpr (operation == arc_tangent2) {
    const double scale = degrees_per_radian / (square(a.value) + square(b.value));
    return times(b.value * scale, a.gradient) - times(a.value * scale, b.gradient);
  }
  if constexpr (operation == hypotenuse) {
    if (value == 0) return {};
    return times(a.value / value, a.gradient) + times(b.value / value, b.gradient);
  }
  if constexpr (operation == select) return a.value != 0 ? b.gradient : c.gradient;
  return {}; // comparisons
}

template <Opcode operation>
Slope slope(const Slope& a, const Slope& b, const Slope& c) {
  const double value = apply<operation>(a.value, b.value, c.value);
  if constexpr (operand_count(operation) == 1)
    return {value, times(derivative<operation>(a.value, value), a.gradient)};
  else
    return {value, gradient_of<operation>(a, b, c, value)};
}

Slope noise_slope(std::uint64_t seed, const Slope& x, const Slope& y, const Slope& z) {
  const auto [value, slope] = gradient_noise_with_gradient(seed, {x.value, y.value, z.value});
  return {value, times(slope.x, x.gradient) + times(slope.y, y.gradient) + times(slope.z, z.gradient)};
}

} // namespace

void evaluate(const Function& function, std::span<const double> inputs, Registers<Slope> registers) {
  assert(inputs.size() == function.input_count && registers.size() >= function.register_count());
  Slope* const r = registers.data();
  Slope* own = r;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    *own = {inputs[i], {}};
    (own++)->gradient[i] = 1;
  }
  for (const double constant : function.constants) *own++ = {constant, {}};
  for (const Instruction& i : function.code) {
    *own++ = dispatch(i.operation, [&]<Opcode operation>() {
      if constexpr (operation == Opcode::noise)
        return noise_slope(function.seeds[i.seed], r[i.a], r[i.b], r[i.c]);
      else
        return slope<operation>(r[i.a], r[i.b], r[i.c]);
    });
  }
}

} // namespace rt
