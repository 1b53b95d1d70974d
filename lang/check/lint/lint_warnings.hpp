#pragma once

#include "lang/check/references.hpp"
#include "lang/diagnostics/report.hpp"

#include <string_view>

/// What the lint says of a text.
namespace rt::lang::warnings {

/// A name that leads to nothing in the scene.
void unused(Report& report, const Declaration& declaration, const SymbolTable& symbols);
/// A thing of which only properties are read.
void only_parts_read(Report& report, const Declaration& declaration, const SymbolTable& symbols);
void hidden_noun(Report& report, Span place, std::string_view word);
/// `text` is a well-known angle in radians.
void radians(Report& report, Span place, double degrees, std::string_view text);
/// An angle that is made with pi.
void turns_in_pi(Report& report, Span place);
/// A camera or lamp that is hardly open at all: `as_radians` is the number in degrees, if it was in radians.
void narrow_angle(Report& report, Span place, double number, double as_radians);

} // namespace rt::lang::warnings
