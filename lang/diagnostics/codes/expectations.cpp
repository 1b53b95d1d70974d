#include "lang/diagnostics/codes/groups.hpp"

#include <vector>

namespace rt::lang::codes {

std::span<const Code> expectations() {
  static const std::vector<Code> table = {
      {"E0701", "An expectation failed",
       "`rtlang test` evaluated an `expect` of the scene, and the result differs. The notes say what was expected "
       "and what "
       "was found. `~` allows a difference of 1e-9, absolute and again relative to what is expected; `within` allows "
       "another one.",
       "", ""},
  };
  return table;
}

} // namespace rt::lang::codes
