#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>

/// What is wrong with a value, wherever it stands: one function a code. The message names what the value is for.
namespace rt::lang::errors {

Diagnostic wrong_property_value(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic value_out_of_bounds(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic not_finite(Span place, std::string message, std::string label = {}, std::string advice = {});
Diagnostic flattened(Span place, std::string message, std::string label = {}, std::string advice = {});

/// Whether another value of the same type might do.
bool is_about_value(const Diagnostic& diagnostic);

} // namespace rt::lang::errors
