#pragma once

#include "lang/check/context.hpp"

#include <span>
#include <string_view>
#include <vector>

/// Check's errors about names.
namespace rt::lang::errors {

/// `known` are the names that could have been intended.
void unknown_name(CheckContext& context, Span place, Symbol name, const std::vector<std::string_view>& known);
/// One of these words is expected.
void unknown_choice(CheckContext& context, Span place, Symbol name, std::span<const std::string_view> choices);
/// `here` is the equivalent in this language.
void name_of_another_language(CheckContext& context, Span place, Symbol name, const std::string& here);
/// In a value from the command line.
void unquoted_string(CheckContext& context, Span place, Symbol name);
void name_bound_twice(CheckContext& context, Symbol name, Span first, Span second);
void name_in_its_own_value(CheckContext& context, Span place, Symbol name, bool is_lambda);
void name_before_its_value(CheckContext& context, Span place, Symbol name, Span later);
/// A name was bound where a property was to be set: it is never read.
void name_hides_property(CheckContext& context, Span place, Symbol name, const Owner& owner);
/// A property of the thing whose block this is, read like a name.
/// `has_block` where braces follow: `background { … }`.
void property_is_no_name(CheckContext& context, Span place, Symbol name, bool has_block);
/// A name that is bound in a block that has already ended.
void name_of_another_block(CheckContext& context, Span place, Symbol name, Span bound);
void parameter_hides_property(CheckContext& context, Span place, Symbol name);

} // namespace rt::lang::errors
