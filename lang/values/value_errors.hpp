#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>

/// Errors about a value, whatever its context: one function per code. The message names what the value is for.
namespace rt::lang::errors {

Diagnostic wrong_property_value(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic value_out_of_bounds(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic not_finite(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic flattened(Span place, std::string message, std::string label = {}, std::string advice = {});

/// Whether another value of the same type might be valid.
bool is_about_value(const Diagnostic& diagnostic);

} // namespace rt::lang::errors
