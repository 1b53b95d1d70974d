#include "renderer/functions/evaluate.hpp"

#include "renderer/functions/apply.hpp"
#include "renderer/math/noise.hpp"

#include <algorithm>
#include <cassert>

namespace rt {

void evaluate(const Function& function, std::span<const double> inputs, Registers<double> registers) {
  assert(inputs.size() == function.input_count && registers.size() >= function.register_count());
  double* const r = registers.data();
  double* own = std::ranges::copy(function.constants, std::ranges::copy(inputs, r).out).out;
  for (const Instruction& i : function.code) {
    *own++ = dispatch(i.operation, [&]<Opcode operation>() {
      if constexpr (operation == Opcode::noise)
        return gradient_noise(function.seeds[i.seed], {r[i.a], r[i.b], r[i.c]});
      else
        return apply<operation>(r[i.a], r[i.b], r[i.c]);
    });
  }
}

void evaluate(const Function& function, std::span<const Batch> inputs, Registers<Batch> registers) {
  assert(inputs.size() == function.input_count && registers.size() >= function.register_count());
  Batch* const r = registers.data();
  Batch* own = std::ranges::copy(inputs, r).out;
  for (const double constant : function.constants) (own++)->lane.fill(constant);
  for (const Instruction& i : function.code) {
    const Batch &a = r[i.a], &b = r[i.b], &c = r[i.c];
    dispatch(i.operation, [&]<Opcode operation>() {
      for (std::size_t k = 0; k < Batch::size; ++k) {
        if constexpr (operation == Opcode::noise)
          own->lane[k] = gradient_noise(function.seeds[i.seed], {a.lane[k], b.lane[k], c.lane[k]});
        else
          own->lane[k] = apply<operation>(a.lane[k], b.lane[k], c.lane[k]);
      }
    });
    ++own;
  }
}

} // namespace rt
