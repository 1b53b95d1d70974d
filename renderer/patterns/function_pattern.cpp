#include "renderer/patterns/function_pattern.hpp"

#include "renderer/functions/evaluate.hpp"

#include <limits>
#include <vector>

namespace rt::scene {

std::span<const Field> fields(const FunctionPattern*) {
  static constexpr Field table[] = {
      field<&FunctionPattern::function>("of", {"fn(p) => 1", "colour or number at the point p"}),
  };
  return table;
}

} // namespace rt::scene

namespace rt {
namespace {

double as_light(double value) {
  return value > 0 && value <= std::numeric_limits<double>::max() ? value : 0;
}

Color color_of(const Function& function, const Vec3& p, Registers<double> registers) {
  const double inputs[] = {p.x, p.y, p.z};
  evaluate(function, inputs, registers);
  const auto channel = [&](std::size_t i) { return as_light(registers[function.results[i]]); };
  return function.results.size() == 1 ? grey(channel(0)) : Color{channel(0), channel(1), channel(2)};
}

} // namespace

// Hardly any function is too long for the stack.
scene::Paint paint_at(const scene::FunctionPattern& pattern, const Vec3& p) {
  const Function& function = *pattern.function;
  constexpr std::size_t few = 512;
  if (function.register_count() > few) {
    std::vector<double> registers(function.register_count());
    return color_of(function, p, registers);
  }
  double registers[few];
  return color_of(function, p, registers);
}

} // namespace rt
