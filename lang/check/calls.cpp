#include "lang/check/calls.hpp"

#include "lang/check/errors/argument_errors.hpp"
#include "lang/check/errors/call_errors.hpp"
#include "lang/values/value.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace rt::lang {
namespace {

/// A parameter of a built-in or user-defined function.
struct CalledParameter {
  std::string_view name;
  bool is_required = true;
  std::optional<Referent> target; ///< what an argument with its name refers to
};

std::vector<CalledParameter> parameters_of(CheckContext& context, const FunctionInfo& function) {
  std::vector<CalledParameter> parameters;
  for (const FunctionInfo::Parameter& p : function.parameters) {
    parameters.push_back({context.name(p.name), p.default_value == no_node, {}});
    if (p.declaration != no_declaration) parameters.back().target = p.declaration;
  }
  return parameters;
}

std::vector<CalledParameter> parameters_of(CheckContext&, const Builtin& builtin) {
  std::vector<CalledParameter> parameters;
  for (const SignatureParameter& p : builtin.signature) parameters.push_back({p.name, !p.is_optional, &p});
  return parameters;
}

bool has_rest(const FunctionInfo&) {
  return false;
}

bool has_rest(const Builtin& builtin) {
  return builtin.signature.has_rest();
}

errors::Callee callee_of(CheckContext& context, const FunctionInfo& function) {
  return errors::callee(context.program.symbols, function);
}

errors::Callee callee_of(CheckContext&, const Builtin& builtin) {
  return errors::callee(builtin.name, builtin.signature);
}

template <class AnyFunction>
void check_arguments(CheckContext& context, const Unit& unit, NodeId call, const AnyFunction& function) {
  const auto report = [&](Diagnostic d) { context.report.add(std::move(d)); };
  const std::vector<CalledParameter> parameters = parameters_of(context, function);
  std::vector<bool> is_given(parameters.size());
  std::size_t positional = 0;
  for (const NodeId argument : unit.ast.call(call).arguments) {
    if (unit.ast.kind(argument) != Kind::argument) {
      if (positional >= parameters.size() && !has_rest(function))
        return report(errors::too_many_arguments(unit.ast.span(argument), callee_of(context, function)));
      is_given[std::min(positional++, parameters.size() - 1)] = true;
      continue;
    }
    const std::string_view word = context.name(unit.ast.named(argument).symbol);
    const Span span = unit.ast.named_span(argument, context.program.symbols);
    const auto found = std::ranges::find(parameters, word, &CalledParameter::name);
    if (found == parameters.end()) {
      std::vector<std::string_view> names;
      for (const CalledParameter& p : parameters) names.push_back(p.name);
      return report(
          errors::unknown_parameter(span, callee_of(context, function), word, errors::guess_label(word, names)));
    }
    if (found->target) context.program.references.add(span, *found->target, Reference::Use::sets);
    const auto i = static_cast<std::size_t>(found - parameters.begin());
    if (is_given[i]) return report(errors::argument_given_twice(span, callee_of(context, function), word));
    is_given[i] = true;
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!is_given[i] && parameters[i].is_required)
      return report(errors::missing_argument(unit.ast.span(call), callee_of(context, function), parameters[i].name));
  }
}

} // namespace

void check_arguments(CheckContext& context, const Unit& unit, NodeId call, const StaticType& callee) {
  if (callee.what == StaticType::What::function && callee.function)
    check_arguments(context, unit, call, *callee.function);
  else if (callee.what == StaticType::What::builtin)
    check_arguments(context, unit, call, *callee.builtin);
  else if (callee.is_thing() && callee.is_bare_noun)
    errors::thing_is_called(context, unit, call, callee);
}

FunctionInfo& add_function(CheckContext& context, Unit& unit, NodeId node) {
  const Function function = unit.ast.function(node);
  const auto index = static_cast<std::uint32_t>(context.program.functions.size());
  FunctionInfo& info = context.program.functions.emplace_back();
  info.unit = &unit;
  info.node = node;
  info.kind = unit.ast.kind(node);
  if (function.name != no_node) info.name = unit.ast.symbol(function.name);
  info.body = function.body;
  for (const NodeId item : function.parameters) {
    if (unit.ast.kind(item) != Kind::parameter) continue;
    const Parameter parameter = unit.ast.parameter(item);
    info.parameters.push_back({unit.ast.symbol(parameter.name), 0, parameter.default_value, parameter.name});
  }
  unit.ast.set_function_index(node, index);
  return info;
}

bool is_ray_question(const CheckContext& context, const Unit& unit, NodeId node) {
  if (unit.ast.kind(node) == Kind::error) return true; // reported
  if (unit.ast.kind(node) != Kind::call) return false;
  const NodeId callee = unit.ast.call(node).callee;
  if (unit.ast.kind(callee) != Kind::name) return false;
  const std::string_view word = context.name(unit.ast.symbol(callee));
  return word == "pixel" || word == "image_point" || word == "ray";
}

} // namespace rt::lang
