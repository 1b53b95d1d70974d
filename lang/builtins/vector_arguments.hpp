#pragma once

#include "lang/values/builtin.hpp"

#include <cstddef>

/// What vector functions require of their arguments; false if it is not satisfied, which is reported.
namespace rt::lang::builtins {

/// The first two arguments have the same number of components.
bool have_equal_sizes(BuiltinCall& call);
/// The i-th is not the zero vector.
bool has_direction(BuiltinCall& call, std::size_t i);

} // namespace rt::lang::builtins
