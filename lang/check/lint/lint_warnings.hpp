#pragma once

#include "lang/check/references.hpp"
#include "lang/diagnostics/report.hpp"

#include <string_view>

/// The lint's warnings about a text.
namespace rt::lang::warnings {

/// A name that does not contribute to the scene.
void unused(Report& report, const Declaration& declaration, const SymbolTable& symbols);
/// A thing of which only properties are read.
void only_parts_read(Report& report, const Declaration& declaration, const SymbolTable& symbols);
void hidden_noun(Report& report, Span place, std::string_view word);
/// `text` is a well-known angle in radians.
void radians(Report& report, Span place, double degrees, std::string_view text);
/// An angle computed with pi.
void turns_in_pi(Report& report, Span place);
/// A camera or lamp with almost no opening angle: `as_radians` is the number converted to degrees, as if in radians.
void narrow_angle(Report& report, Span place, double number, double as_radians);

} // namespace rt::lang::warnings
