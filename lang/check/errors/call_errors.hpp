#pragma once

#include "lang/check/context.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What check says about calls, arguments and what stands after a dot.
namespace rt::lang::errors {

/// A thing is called like a function.
void thing_is_called(CheckContext& context, const Unit& unit, NodeId call, const StaticType& callee);

/// A function whose arguments are checked, as messages name it.
struct Callee {
  std::string name; ///< "`wave`", "this function"
  Note takes;       ///< which arguments it takes
  std::string most; ///< how many: "2 arguments", "at most 2 arguments"
};
void too_many_arguments(CheckContext& context, Span place, const Callee& callee);
void unknown_parameter(CheckContext& context, Span place, const Callee& callee, std::string_view word,
                       const std::vector<std::string_view>& parameters);
void argument_given_twice(CheckContext& context, Span place, const Callee& callee, std::string_view word);
void missing_argument(CheckContext& context, Span place, const Callee& callee, std::string_view parameter);

/// A chain method without its thing.
void method_without_thing(CheckContext& context, Span place, std::string_view method);
/// Braces behind what is no thing.
void not_a_thing(CheckContext& context, Span place, bool is_module);
void unknown_export(CheckContext& context, Span place, Symbol name, const ModuleInfo& module);
void unknown_method(CheckContext& context, Span place, std::string_view word);

} // namespace rt::lang::errors
