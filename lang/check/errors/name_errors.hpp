#pragma once

#include "lang/check/context.hpp"

#include <span>
#include <string_view>
#include <vector>

/// What check says about names.
namespace rt::lang::errors {

/// `known` are the names that could have been meant.
void unknown_name(CheckContext& context, Span place, Symbol name, const std::vector<std::string_view>& known);
/// Where one of these words is wanted.
void unknown_choice(CheckContext& context, Span place, Symbol name, std::span<const std::string_view> choices);
/// `here` says what this language has instead.
void name_of_another_language(CheckContext& context, Span place, Symbol name, const std::string& here);
/// In a value of the command line.
void unquoted_string(CheckContext& context, Span place, Symbol name);
void name_bound_twice(CheckContext& context, Symbol name, Span first, Span second);
void name_in_its_own_value(CheckContext& context, Span place, Symbol name, bool is_lambda);
void name_before_its_value(CheckContext& context, Span place, Symbol name, Span later);
/// A name that was bound where a property was to be set: nothing reads it.
void name_hides_property(CheckContext& context, Span place, Symbol name, const Owner& owner);
/// A property of the thing whose block it is, read like a name.
/// `has_block` where braces follow: `background { … }`.
void property_is_no_name(CheckContext& context, Span place, Symbol name, bool has_block);
/// A name that is bound in a block that has ended.
void name_of_another_block(CheckContext& context, Span place, Symbol name, Span bound);
void parameter_hides_property(CheckContext& context, Span place, Symbol name);

} // namespace rt::lang::errors
