#pragma once

#include "lang/check/context.hpp"

#include <string_view>

namespace rt::lang {

/// Whether the arguments of the call fit the parameters of what it calls, as far as their number and names go.
void check_arguments(CheckContext& context, const Unit& unit, NodeId call, const StaticType& callee);
/// A new entry of `Program::functions` for a def, fn or lambda, which its node then names.
FunctionInfo& add_function(CheckContext& context, Unit& unit, NodeId node);
/// Whether an `expect` may say of the expression that it hits something.
bool is_ray_question(const CheckContext& context, const Unit& unit, NodeId node);

} // namespace rt::lang
