#pragma once

#include "lang/check/context.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Check's errors about calls and what follows a dot.
namespace rt::lang::errors {

/// A thing is called like a function.
void thing_is_called(CheckContext& context, const Unit& unit, NodeId call, const StaticType& callee);

/// "did you mean …?" of the nearest of the names, empty if none is near.
std::string guess_label(std::string_view word, const std::vector<std::string_view>& names);

/// A chain method without its thing.
void method_without_thing(CheckContext& context, Span place, std::string_view method);
/// Braces after something that is not a thing.
void not_a_thing(CheckContext& context, Span place, bool is_module);
void unknown_export(CheckContext& context, Span place, Symbol name, const ModuleInfo& module);
void unknown_method(CheckContext& context, Span place, std::string_view word);

} // namespace rt::lang::errors
