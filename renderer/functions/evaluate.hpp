#pragma once

#include "renderer/functions/function.hpp"
#include "renderer/math/vec3.hpp"

#include <array>
#include <span>

namespace rt {

/// What the evaluations of a function are made in: as many as it has registers, and no allocation. Their content
/// before does not matter; afterwards the results are in the function's `results`.
template <class T>
using Registers = std::span<T>;

/// At one point. There are as many inputs as the function has.
void evaluate(const Function& function, std::span<const double> inputs, Registers<double> registers);

/// Numbers of eight points.
struct Batch {
  static constexpr std::size_t size = 8;
  alignas(64) std::array<double, size> lane{};
};
/// At eight points at a time: at each, what `evaluate` gives, to the last bit.
void evaluate(const Function& function, std::span<const Batch> inputs, Registers<Batch> registers);

/// A number, and how it changes with each of the inputs.
struct Slope {
  double value = 0;
  Vec3 gradient{};
};
/// With the gradient by the inputs, by forward differentiation. Where a function has a kink, the gradient is that of
/// one side; that of a step is 0.
void evaluate(const Function& function, std::span<const double> inputs, Registers<Slope> registers);

} // namespace rt
