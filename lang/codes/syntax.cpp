#include "lang/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> syntax() {
  static const std::vector<Code> table = {
  };
  return table;
}

} // namespace rt::lang::codes
