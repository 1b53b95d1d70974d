#include "lang/builtins/vector_arguments.hpp"

#include "lang/values/formula.hpp"

namespace rt::lang::builtins {

bool have_equal_sizes(BuiltinCall& c) {
  if (vector_like_size(c[0]) == vector_like_size(c[1])) return true;
  c.fail(1, "both vectors must have the same number of components");
  return false;
}

bool has_direction(BuiltinCall& c, std::size_t i) {
  if (length(c.vector(i)) > 0) return true;
  c.fail(i, "a vector of length 0 has no direction", "this is zero");
  return false;
}

} // namespace rt::lang::builtins
