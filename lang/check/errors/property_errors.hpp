#pragma once

#include "lang/check/context.hpp"

/// Check's errors about properties.
namespace rt::lang::errors {

void property_without_thing(CheckContext& context, Span place, Symbol name);
/// `item` sets a property that its owner does not have.
void unknown_property(CheckContext& context, const Unit& unit, NodeId item, const Owner& owner);

} // namespace rt::lang::errors
