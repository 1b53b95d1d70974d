#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/values/node_types.hpp"
#include "lang/values/value.hpp"

#include <optional>

namespace rt::lang {

/// What is wrong with the value of a property, its type or else its constraint;
/// the place is the caller's to fill in. Poison passes.
std::optional<Diagnostic> check_value(const Property& property, const Value& value);

} // namespace rt::lang
