#pragma once

#include "lang/diagnostics/diagnostic.hpp"

/// Errors in files of other programs; the places are in those files.
namespace rt::tools::import::errors {

lang::Diagnostic malformed_line(lang::Span place, std::string message, std::string label, std::string advice = {});
lang::Diagnostic unknown_element(lang::Span place, std::string message, std::string advice);
/// One is missing, or there are too many; `others` are the places of the earlier ones.
lang::Diagnostic wrong_count(lang::Span place, std::string message, std::vector<lang::Note> others = {});
/// Is accepted, but not as written.
lang::Diagnostic taken_otherwise(lang::Span place, std::string message, std::string label);

} // namespace rt::tools::import::errors
