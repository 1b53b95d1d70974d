#pragma once

#include "renderer/functions/function_builder.hpp"
#include "renderer/math/random.hpp"

#include <cmath>
#include <vector>

namespace rt::tests {

/// A function of three numbers that is `length` random operations long; its last three values are its results.
inline Function random_function(SplitMix64& random, int length) {
  FunctionBuilder builder(3);
  std::vector<FunctionBuilder::Node> nodes{builder.input(0), builder.input(1), builder.input(2)};
  const auto any = [&] {
    if (random.unit() < 0.2)
      return builder.constant(random.unit() < 0.5 ? random.between(-4, 4) : std::floor(random.between(-4, 5)));
    const double recent = 1 - random.unit() * random.unit(); // what was made last is used most
    return nodes[static_cast<std::size_t>(recent * static_cast<double>(nodes.size() - 1))];
  };
  constexpr int count = static_cast<int>(Opcode::noise) + 1;
  for (int i = 0; i < length; ++i) {
    const auto operation = static_cast<Opcode>(static_cast<int>(random.unit() * count));
    const FunctionBuilder::Node a = any(), b = any(), c = any();
    nodes.push_back(operation == Opcode::noise ? builder.noise(random.bits() % 3, a, b, c)
                                               : builder.apply(operation, a, b, c));
  }
  const FunctionBuilder::Node results[] = {nodes.end()[-1], nodes.end()[-2], nodes.end()[-3]};
  return builder.finish(results);
}

} // namespace rt::tests
