#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/diagnostic.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Arguments that do not match a function. Check finds them if it knows the function, evaluation if only the values
/// determine which one is called.
namespace rt::lang::errors {

/// A called function, as messages describe it.
struct Callee {
  std::string name;        ///< "`wave`", "this function"
  std::string most;        ///< how many arguments it takes: "2 arguments", "at most 2 arguments"
  std::vector<Note> takes; ///< the arguments it takes
};
Callee callee(const SymbolTable& symbols, const FunctionInfo& function);
Callee callee(std::string_view name, const Signature& signature);

/// `place` is the first excess argument.
Diagnostic too_many_arguments(Span place, const Callee& callee);
/// The same for a function called by another one, with `count` arguments.
Diagnostic called_with_too_many(Span place, const Callee& callee, std::size_t count);
Diagnostic unknown_parameter(Span place, const Callee& callee, std::string_view word, std::string label = {});
Diagnostic argument_given_twice(Span place, const Callee& callee, std::string_view word);
Diagnostic missing_argument(Span place, const Callee& callee, std::string_view parameter);

} // namespace rt::lang::errors
