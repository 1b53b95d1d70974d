#pragma once

#include "lang/check/context.hpp"

#include <string_view>

/// What check says about properties.
namespace rt::lang::errors {

void property_without_thing(CheckContext& context, Span place, Symbol name);
/// `item` sets a property that its owner does not have.
void unknown_property(CheckContext& context, const Unit& unit, NodeId item, const Owner& owner);
void property_set_twice(CheckContext& context, Span place, Symbol name, Span first);
/// Two properties of different forms, which say the same in two ways.
void two_forms(CheckContext& context, Span place, std::string_view name, Span other_place, std::string_view other);

} // namespace rt::lang::errors
