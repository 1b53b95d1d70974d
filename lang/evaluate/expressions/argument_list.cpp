#include "lang/evaluate/expressions/argument_list.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/expressions/expression_evaluator.hpp"
#include "lang/values/properties.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

bool is_of(const Value& value, const SignatureParameter& parameter) {
  if (parameter.takes(ArgumentType::any)) return true;
  switch (value.kind()) {
  case ValueKind::number:
    if (parameter.takes(ArgumentType::number)) return true;
    break;
  case ValueKind::boolean:
    return parameter.takes(ArgumentType::boolean);
  case ValueKind::string:
    return parameter.takes(ArgumentType::string);
  case ValueKind::vector:
    if (parameter.takes(ArgumentType::point) || parameter.takes(ArgumentType::list)) return true;
    return value.vector_size() == 3 && parameter.takes(ArgumentType::vector);
  case ValueKind::list:
  case ValueKind::range:
    return parameter.takes(ArgumentType::list);
  case ValueKind::closure:
  case ValueKind::builtin:
    if (parameter.takes(ArgumentType::function)) return true;
    break;
  default:
    break;
  }
  return parameter.takes(ArgumentType::color) && as_color(value).has_value();
}

/// "a number or a vector" from "number or vector".
std::string with_articles(std::string_view types) {
  std::string text;
  while (!types.empty()) {
    const std::size_t end = std::min(types.find(" or "), types.size());
    const std::string_view word = types.substr(0, end);
    text += text.empty() ? "a " : " or a ";
    if (word == "vector")
      text += "vector of three numbers";
    else if (word == "point")
      text += "vector";
    else if (word == "color")
      text += "colour";
    else
      text += word;
    types.remove_prefix(std::min(end + 4, types.size()));
  }
  return text;
}

} // namespace

ArgumentList::ArgumentList(Evaluation& evaluation, CallEvaluator& calls, ThingSource& things, std::string_view name,
                           const Signature& signature, Span place)
    : evaluation_(evaluation), calls_(calls), things_(things), name_(name), signature_(signature), place_(place) {
  arguments.resize(signature.size() - (signature.has_rest() ? 1 : 0), Value::unset());
  places_.resize(arguments.size());
}

bool ArgumentList::put(std::size_t i, Value value, Span place) {
  if (i >= arguments.size()) {
    arguments.resize(i + 1, Value::unset());
    places_.resize(i + 1);
  }
  arguments[i] = std::move(value);
  places_[i] = place;
  return !arguments[i].is_poison();
}

bool ArgumentList::read(NodeId node, const Context& context, ExpressionEvaluator& expressions) {
  const Ast& ast = context.ast();
  bool is_fine = true;
  std::size_t position = 0;
  for (const NodeId argument : ast.call(node).arguments) {
    const bool is_named = ast.kind(argument) == Kind::argument;
    const NodeId value_node = is_named ? ast.named(argument).value : argument;
    Value value = expressions.evaluate(value_node, context);
    std::size_t i = position;
    if (is_named) {
      const std::string_view word = evaluation_.errors.name(ast.named(argument).symbol);
      i = static_cast<std::size_t>(std::ranges::find(signature_, word, &SignatureParameter::name) - signature_.begin());
      if (i == signature_.size()) {
        is_fine =
            refuse(errors::unknown_parameter(ast.named_span(argument, evaluation_.program.symbols), callee(), word));
        continue;
      }
      if (has(i))
        is_fine =
            refuse(errors::argument_given_twice(ast.named_span(argument, evaluation_.program.symbols), callee(), word));
    } else if (++position > signature_.size() && !signature_.has_rest()) {
      return refuse(errors::too_many_arguments(ast.span(argument), callee()));
    }
    is_fine &= put(i, std::move(value), ast.span(value_node));
  }
  return is_fine && are_complete();
}

bool ArgumentList::take(std::vector<Value> values) {
  if (values.size() > signature_.size() && !signature_.has_rest())
    return refuse(errors::called_with_too_many(place_, callee(), values.size()));
  bool is_fine = true;
  for (std::size_t i = 0; i < values.size(); ++i) is_fine &= put(i, std::move(values[i]), place_);
  return is_fine && are_complete();
}

bool ArgumentList::refuse(Diagnostic diagnostic) {
  evaluation_.errors.fail(std::move(diagnostic));
  return false;
}

errors::Callee ArgumentList::callee() const {
  return errors::callee(name_, signature_);
}

bool ArgumentList::are_complete() {
  for (std::size_t i = 0; i < signature_.size(); ++i) {
    if (has(i) || signature_[i].is_optional) continue;
    return refuse(errors::missing_argument(place_, callee(), signature_[i].name));
  }
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (has(i) && !check_type(i)) return false;
  }
  return true;
}

bool ArgumentList::check_type(std::size_t i) {
  const SignatureParameter& parameter = signature_[std::min(i, signature_.size() - 1)];
  if (is_of(arguments[i], parameter)) return true;
  return refuse(
      errors::wrong_argument(place_of(i),
                             fmt::format("`{}` takes {} for `{}`, not {}", name_, with_articles(parameter.types_text),
                                         parameter.name, describe(arguments[i])),
                             "this is " + describe(arguments[i])));
}

Heap& ArgumentList::heap() {
  return evaluation_.heap;
}
const SymbolTable& ArgumentList::symbols() {
  return evaluation_.program.symbols;
}

Value ArgumentList::call(const Value& function, std::vector<Value> function_arguments) {
  return calls_.call_function(function, std::move(function_arguments), place_);
}

Value ArgumentList::fail(std::size_t argument, const std::string& message, const std::string& label) {
  return evaluation_.errors.fail(errors::no_result(place_of(argument), message, label));
}

void ArgumentList::print(std::string text) {
  evaluation_.errors.print(std::move(text), place_);
}

void ArgumentList::spend(std::uint64_t steps, std::uint64_t bytes) {
  evaluation_.limits.spend(steps, place_);
  if (bytes > 0) evaluation_.limits.reserve(bytes, place_);
}

std::optional<double> ArgumentList::precision() {
  return things_.precision();
}

const Observer* ArgumentList::observer(std::optional<std::size_t> alone) {
  if (!alone || !has(*alone)) return things_.observer();
  return things_.observer_of(arguments[*alone], place_of(*alone));
}

const scene::Scene& ArgumentList::scene() {
  return evaluation_.builder.scene;
}

} // namespace rt::lang
