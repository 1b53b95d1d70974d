#include "renderer/functions/opcode.hpp"

#include <iterator>

namespace rt {

std::string_view spelling(Opcode operation) {
  static constexpr std::string_view words[] = {
      "-",   "abs",   "floor", "ceil",  "round", "sqrt", "sin", "cos", "tan",    "asin", "acos", "atan",
      "exp", "log",   "log2",  "log10", "not",   "+",    "-",   "*",   "/",      "%",    "^",    "min",
      "max", "atan2", "hypot", "<",     "<=",    "==",   "and", "or",  "select", "noise"};
  static_assert(std::size(words) == static_cast<std::size_t>(Opcode::noise) + 1);
  return words[static_cast<std::size_t>(operation)];
}

bool is_infix(Opcode operation) {
  switch (operation) {
  case Opcode::add:
  case Opcode::subtract:
  case Opcode::multiply:
  case Opcode::divide:
  case Opcode::modulo:
  case Opcode::power:
  case Opcode::less:
  case Opcode::less_equal:
  case Opcode::equal:
  case Opcode::and_:
  case Opcode::or_:
    return true;
  default:
    return false;
  }
}

} // namespace rt
