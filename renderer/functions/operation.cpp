#include "renderer/functions/operation.hpp"

#include <iterator>

namespace rt {

std::string_view spelling(Operation operation) {
  static constexpr std::string_view words[] = {
      "-",   "abs",   "floor", "ceil",  "round", "sqrt", "sin", "cos", "tan",    "asin", "acos", "atan",
      "exp", "log",   "log2",  "log10", "not",   "+",    "-",   "*",   "/",      "%",    "^",    "min",
      "max", "atan2", "hypot", "<",     "<=",    "==",   "and", "or",  "select", "noise"};
  static_assert(std::size(words) == static_cast<std::size_t>(Operation::noise) + 1);
  return words[static_cast<std::size_t>(operation)];
}

bool is_infix(Operation operation) {
  switch (operation) {
  case Operation::add:
  case Operation::subtract:
  case Operation::multiply:
  case Operation::divide:
  case Operation::modulo:
  case Operation::power:
  case Operation::less:
  case Operation::less_equal:
  case Operation::equal:
  case Operation::and_:
  case Operation::or_:
    return true;
  default:
    return false;
  }
}

} // namespace rt
