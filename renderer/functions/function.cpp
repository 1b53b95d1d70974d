#include "renderer/functions/function.hpp"

#include "renderer/math/format_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

std::string operand(const Function& function, Register r) {
  if (function.is_input(r)) return std::string(1, "xyz"[r]);
  if (function.is_constant(r)) return format_number(function.constant(r));
  return fmt::format("t{}", r - function.first_instruction() + 1);
}

std::string expression(const Function& function, const Instruction& i) {
  const std::string a = operand(function, i.a), b = operand(function, i.b), c = operand(function, i.c);
  const std::string_view word = spelling(i.operation);
  if (is_infix(i.operation)) return fmt::format("{} {} {}", a, word, b);
  if (i.operation == Opcode::negate) return "-" + a;
  if (i.operation == Opcode::noise) return fmt::format("noise({}, {}, {}, seed {})", a, b, c, function.seeds[i.seed]);
  switch (operand_count(i.operation)) {
  case 1:
    return fmt::format("{}({})", word, a);
  case 2:
    return fmt::format("{}({}, {})", word, a, b);
  default:
    return fmt::format("{}({}, {}, {})", word, a, b, c);
  }
}

} // namespace

bool is_well_formed(const Function& f) {
  if (f.input_count < 1 || f.input_count > 3 || (f.results.size() != 1 && f.results.size() != 3)) return false;
  if (f.code.size() > Function::most_instructions || f.constants.size() > 3 * Function::most_instructions) return false;
  if (!std::ranges::all_of(f.constants, [](double v) { return std::isfinite(v); })) return false;
  Register own = f.first_instruction();
  for (const Instruction& i : f.code) {
    if (i.operation > Opcode::noise || i.a >= own || i.b >= own || i.c >= own) return false;
    if (i.operation == Opcode::noise && i.seed >= f.seeds.size()) return false;
    ++own;
  }
  return std::ranges::all_of(f.results, [&](Register r) { return r < own; });
}

std::vector<std::string> listing(const Function& function) {
  std::vector<std::string> lines;
  Register own = function.first_instruction();
  for (const Instruction& i : function.code)
    lines.push_back(fmt::format("{} = {}", operand(function, own++), expression(function, i)));
  const auto result = [&](std::size_t i) { return operand(function, function.results[i]); };
  lines.push_back(function.results.size() == 1 ? result(0)
                                               : fmt::format("[{}, {}, {}]", result(0), result(1), result(2)));
  return lines;
}

} // namespace rt
