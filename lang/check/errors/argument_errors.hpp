#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/diagnostic.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Arguments that do not fit a function. Check finds them where it knows the function, and evaluation where only the
/// values show which one is called.
namespace rt::lang::errors {

/// A called function, as messages name it.
struct Callee {
  std::string name;        ///< "`wave`", "this function"
  std::string most;        ///< how many arguments it takes: "2 arguments", "at most 2 arguments"
  std::vector<Note> takes; ///< which arguments
};
Callee callee(const SymbolTable& symbols, const FunctionInfo& function);
Callee callee(std::string_view name, const Signature& signature);

/// `place` is the first argument that is one too many.
Diagnostic too_many_arguments(Span place, const Callee& callee);
/// The same for a function that another one calls, with `count` arguments.
Diagnostic called_with_too_many(Span place, const Callee& callee, std::size_t count);
Diagnostic unknown_parameter(Span place, const Callee& callee, std::string_view word, std::string label = {});
Diagnostic argument_given_twice(Span place, const Callee& callee, std::string_view word);
Diagnostic missing_argument(Span place, const Callee& callee, std::string_view parameter);

} // namespace rt::lang::errors
