#pragma once

#include "renderer/functions/opcode.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// The place of a value of a function: first its inputs, then its constants, then what each instruction gives.
using Register = std::uint32_t;

/// One step of a function. Operands that the operation does not have are 0.
struct Instruction {
  Opcode operation{};
  std::uint16_t seed = 0; ///< of noise: index in `Function::seeds`
  Register a = 0, b = 0, c = 0;
  friend bool operator==(const Instruction&, const Instruction&) = default;
};

/// A function from one to three numbers (a point's coordinates, mostly) to one number, or to three: a colour or a
/// vector. Straight-line code in single assignment form: every instruction has a register of its own, and reads only
/// registers before it.
struct Function {
  static constexpr std::size_t most_instructions = 65'536;

  std::uint32_t input_count = 3;
  std::vector<double> constants; ///< finite
  std::vector<std::uint64_t> seeds;
  std::vector<Instruction> code;
  std::vector<Register> results; ///< one or three
  friend bool operator==(const Function&, const Function&) = default;

  std::size_t register_count() const { return input_count + constants.size() + code.size(); }
  Register first_constant() const { return input_count; }
  Register first_instruction() const { return static_cast<Register>(input_count + constants.size()); }
  bool is_input(Register r) const { return r < first_constant(); }
  bool is_constant(Register r) const { return r >= first_constant() && r < first_instruction(); }
  double constant(Register r) const { return constants[r - first_constant()]; }
};

/// Whether all registers are there and come before those that read them, and constants are finite. Nothing but the
/// functions below may be done with one that is not.
bool is_well_formed(const Function& function);

/// A line for each instruction, and one for the results: `t1 = x * x`, `t2 = sin(t1)`, `[t1, t2, 0.5]`. The inputs are
/// called x, y and z.
std::vector<std::string> listing(const Function& function);

} // namespace rt
