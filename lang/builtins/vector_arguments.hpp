#pragma once

#include "lang/values/builtin.hpp"

#include <cstddef>

/// What functions of vectors require of their arguments; false where it does not hold, which is reported.
namespace rt::lang::builtins {

/// The first two arguments have as many numbers.
bool have_equal_sizes(BuiltinCall& call);
/// The i-th is not the zero vector.
bool has_direction(BuiltinCall& call, std::size_t i);

} // namespace rt::lang::builtins
