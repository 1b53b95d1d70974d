#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Errors that check finds if it can, and evaluation if they depend on values: one function per code.
namespace rt::lang::errors {

Diagnostic no_value_yet(Span place, std::string message, std::string label, std::vector<Note> notes = {});
/// The owner of a block has no such property.
Diagnostic no_property(Span place, std::string message, std::string label, std::vector<Note> notes = {});
Diagnostic property_set_twice(Span place, std::string_view name, Span first);
/// Two properties of different forms, which specify the same in two ways.
Diagnostic two_forms(Span place, std::string_view name, Span other_place, std::string_view other);
/// A thing is called like a function.
Diagnostic called_thing(Span place, std::string_view thing, std::string label);
/// What precedes braces or a dot is not a thing.
Diagnostic no_thing(Span place, std::string message, std::string label);
/// What follows a dot does not exist.
Diagnostic no_member(Span place, std::string message, std::string label);
/// Things, lists or loop variables are nested too deeply.
Diagnostic too_deep(Span place, std::string message, std::string label = {});

} // namespace rt::lang::errors
