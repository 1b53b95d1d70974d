#pragma once

#include "lang/check/context.hpp"

#include <string_view>

namespace rt::lang {

/// Checks the number and names of the call's arguments against the parameters of what it calls.
void check_arguments(CheckContext& context, const Unit& unit, NodeId call, const StaticType& callee);
/// Adds an entry to `Program::functions` for a def, fn or lambda; its node then refers to it.
FunctionInfo& add_function(CheckContext& context, Unit& unit, NodeId node);
/// Whether an `expect` may claim that the expression hits something.
bool is_ray_question(const CheckContext& context, const Unit& unit, NodeId node);

} // namespace rt::lang
