#include "lang/check/errors/argument_errors.hpp"

#include "lang/values/value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace rt::lang::errors {
namespace {

Diagnostic wrong_arguments(Span place, const Callee& callee, std::string message, std::string label = {}) {
  return make_error("E0208", place, std::move(message), std::move(label), callee.takes);
}

} // namespace

Callee callee(const SymbolTable& symbols, const FunctionInfo& function) {
  std::vector<std::string_view> names;
  for (const FunctionInfo::Parameter& p : function.parameters) names.push_back(symbols.name(p.name));
  return {function.name == no_symbol ? "this function" : fmt::format("`{}`", symbols.name(function.name)),
          count_of_arguments(names.size()),
          {{function.unit->ast.span(function.node), fmt::format("it takes ({})", fmt::join(names, ", "))}}};
}

Callee callee(std::string_view name, const Signature& signature) {
  return {fmt::format("`{}`", name),
          "at most " + count_of_arguments(signature.size()),
          {{std::nullopt, fmt::format("{}({})", name, signature.text())}}};
}

Diagnostic too_many_arguments(Span place, const Callee& callee) {
  return wrong_arguments(place, callee, fmt::format("{} takes {}", callee.name, callee.most), "one too many");
}

Diagnostic called_with_too_many(Span place, const Callee& callee, std::size_t count) {
  return wrong_arguments(
      place, callee,
      fmt::format("{} is called with {}, and takes {}", callee.name, count_of_arguments(count), callee.most));
}

Diagnostic unknown_parameter(Span place, const Callee& callee, std::string_view word, std::string label) {
  return wrong_arguments(place, callee, fmt::format("{} has no parameter `{}`", callee.name, word), std::move(label));
}

Diagnostic argument_given_twice(Span place, const Callee& callee, std::string_view word) {
  return wrong_arguments(place, callee, fmt::format("`{}` is given twice", word));
}

Diagnostic missing_argument(Span place, const Callee& callee, std::string_view parameter) {
  return wrong_arguments(place, callee, fmt::format("{} needs a value for `{}`", callee.name, parameter));
}

} // namespace rt::lang::errors
