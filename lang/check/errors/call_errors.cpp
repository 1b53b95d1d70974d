#include "lang/check/errors/call_errors.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/check/errors/dialects.hpp"
#include "lang/check/errors/shared_errors.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

namespace rt::lang::errors {
namespace {

/// The arguments of a call, rewritten as the properties that they were meant to be.
std::string as_properties(CheckContext& context, const Ast& ast, NodeId call, const StaticType& callee) {
  const NodeList arguments = ast.call(call).arguments;
  std::string properties;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view value = context.text(ast.span(arguments[i]));
    if (i > 0) properties += ", ";
    if (ast.kind(arguments[i]) == Kind::argument)
      properties += value;
    else if (callee.function && i < callee.function->parameters.size())
      properties += fmt::format("{}: {}", context.name(callee.function->parameters[i].name), value);
    else if (!callee.function && i < callee.type->properties.size())
      properties += fmt::format("{}: {}", callee.type->properties[i].name, value);
  }
  return properties;
}

} // namespace

std::string guess_label(std::string_view word, const std::vector<std::string_view>& names) {
  const auto guess = nearest(word, names);
  return guess ? fmt::format("did you mean `{}`?", *guess) : "";
}

void thing_is_called(CheckContext& context, const Unit& unit, NodeId call, const StaticType& callee) {
  const std::string_view type = callee.function ? context.name(callee.function->name) : callee.type->name;
  const std::string properties = as_properties(context, unit.ast, call, callee);
  context.report.add(called_thing(unit.ast.span(call), fmt::format("`{}`", type),
                                  properties.empty() ? fmt::format("write `{} {{}}`", type)
                                                     : fmt::format("write `{} {{ {} }}`", type, properties)));
}

void method_without_thing(CheckContext& context, Span place, std::string_view method) {
  context.report.add(no_thing(place, fmt::format("`{}` is written after a thing", method),
                              fmt::format("write `thing.{}(…)`", method)));
}

void not_a_thing(CheckContext& context, Span place, bool is_module) {
  context.report.add(
      no_thing(place, fmt::format("`{}` is a {}, not a thing", context.text(place), is_module ? "file" : "function"),
               is_module ? "write the name of a thing in it, after a dot" : "a function takes its arguments in ( )"));
}

void unknown_export(CheckContext& context, Span place, Symbol name, const ModuleInfo& module) {
  std::vector<std::string_view> names;
  for (const ModuleInfo::Export& e : module.exports) names.push_back(context.name(e.name));
  context.report.add(no_member(place, fmt::format("the file has no name `{}`", context.name(name)),
                               guess_label(context.name(name), names)));
}

void unknown_method(CheckContext& context, Span place, std::string_view word) {
  std::vector<std::string_view> names;
  for (const ChainMethod& method : chain_methods()) names.push_back(method.name);
  const std::string other = dialect_name(word);
  context.report.add(
      no_member(place, fmt::format("a thing has no `.{}(…)`", word), other.empty() ? guess_label(word, names) : other));
}

} // namespace rt::lang::errors
