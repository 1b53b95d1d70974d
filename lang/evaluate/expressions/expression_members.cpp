#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/expressions/expression_evaluator.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang {
namespace {

bool is_word_for_size(std::string_view word) {
  return word == "len" || word == "length" || word == "size" || word == "count";
}

} // namespace

Value ExpressionEvaluator::unknown_member(std::string message, std::string_view word, Span place,
                                          std::span<const std::string_view> names) {
  if (const auto guess = nearest(word, names))
    return fail(errors::no_member(place, std::move(message), fmt::format("did you mean `{}`?", *guess)));
  const bool is_function =
      std::ranges::any_of(all_builtins(), [&](const Builtin* builtin) { return builtin->name == word; });
  return fail(errors::no_member(place, std::move(message),
                                is_function ? fmt::format("a function comes first: `{}(…)`", word) : ""));
}

Value ExpressionEvaluator::index_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Index parts = ast.index(node);
  const Value base = evaluate(parts.base, context);
  const Value index = evaluate(parts.index, context);
  if (base.is_poison() || index.is_poison()) return Value::poison();
  if (!is_sequence(base))
    return fail(errors::wrong_operand(ast.span(parts.base), "only a list has elements", "this is " + describe(base)));
  if (!index.is_number())
    return fail(
        errors::wrong_operand(ast.span(parts.index), "a list index must be a number", "this is " + describe(index)));
  const double size =
      base.is(ValueKind::range) ? count(base.range(), base.excludes_end()) : static_cast<double>(sequence_size(base));
  const double i = index.number();
  if (i != std::floor(i))
    return fail(
        errors::no_element(ast.span(parts.index), "a list index must be an integer", "this is " + format_number(i)));
  if (!(i >= -size && i < size)) {
    return fail(errors::no_element(ast.span(parts.index), fmt::format("there is no element {}", format_number(i)),
                                   fmt::format("the list has {}, counted from 0", format_number(size))));
  }
  return sequence_at(base, static_cast<std::size_t>(i < 0 ? i + size : i));
}

Value ExpressionEvaluator::member_value(NodeId node, const Context& context) {
  const Value base = evaluate(context.ast().member(node).base, context);
  return base.is_poison() ? base : member_of(base, node, context);
}

Value ExpressionEvaluator::member_of(const Value& base, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Symbol symbol = ast.member(node).symbol;
  const std::string_view word = name(symbol);
  const Span place = ast.member_span(node, program_.symbols);
  const auto unknown = [&](std::string message, std::span<const std::string_view> names) {
    if ((is_sequence(base) || base.is(ValueKind::string)) && is_word_for_size(word))
      return fail(errors::no_member(place, std::move(message),
                                    base.is(ValueKind::vector) && word == "length"
                                        ? "`len(…)` counts the elements, `length(…)` measures a vector"
                                        : "`len(…)` counts the elements"));
    return unknown_member(std::move(message), word, place, names);
  };
  switch (base.kind()) {
  case ValueKind::record: {
    if (const Value* found = base.record().find(symbol)) return *found;
    std::vector<std::string_view> names;
    for (const Record::RecordEntry& entry : base.record().entries) names.push_back(name(entry.name));
    return unknown(fmt::format("this record has no field `{}`", word), names);
  }
  case ValueKind::module: {
    const Module& module = base.module();
    if (const ModuleInfo::Export* found = module.info->find(symbol)) {
      if (found->function) return function_value(*found->function, module.frame.get(), ast.span(node));
      return (*module.frame)[found->slot];
    }
    return Value::poison(); // reported by check
  }
  case ValueKind::vector:
    if (word == "x") return base.vector().x;
    if (word == "y") return base.vector().y;
    if (word == "z" && base.vector_size() == 3) return base.vector().z;
    return unknown(fmt::format("{} has no part `{}`", describe(base), word), {});
  case ValueKind::color:
    if (word == "r") return base.color().r;
    if (word == "g") return base.color().g;
    if (word == "b") return base.color().b;
    return unknown(fmt::format("a colour has no part `{}`", word), {});
  case ValueKind::formula:
    if (auto part = formula_member(base, word)) return *std::move(part);
    return unknown(fmt::format("{} has no part `{}`", describe(base), word), {});
  case ValueKind::thing:
    return thing_member(base.thing(), node, context);
  default:
    return unknown(fmt::format("{} has no part `{}`", describe(base), word), {});
  }
}

Value ExpressionEvaluator::thing_member(const Thing& thing, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Symbol symbol = ast.member(node).symbol;
  const std::string_view word = name(symbol);
  const Span place = ast.member_span(node, program_.symbols);
  if (thing.def) {
    if (const auto i = thing.def->find(symbol)) {
      if (const PropertyValue* found = thing.find(parameter_id(*i))) return found->value;
      return fail(errors::no_member(place, fmt::format("`{}` was not set for this thing", word),
                                    "only parameters that were set can be read"));
    }
  }
  if (const auto id = thing.type->find(symbol)) {
    if (const PropertyValue* found = thing.find(*id)) return found->value;
    if (const auto value = default_value(*thing.type, thing.type->properties[*id])) return *value;
    return fail(errors::no_member(place, fmt::format("`{}` was not set for this thing", word), "it has no value"));
  }
  if (find_chain_method(word))
    return fail(
        errors::no_member(place, fmt::format("`.{}` needs its arguments", word), fmt::format("write `.{}(…)`", word)));
  std::vector<std::string_view> names;
  for (const Property& property : thing.type->properties) names.push_back(property.name);
  const auto guess = nearest(word, names);
  return fail(errors::no_member(
      place, fmt::format("{} has no property `{}`", describe(Value(Ref<Thing>(const_cast<Thing*>(&thing)))), word),
      guess ? fmt::format("did you mean `{}`?", *guess) : ""));
}

} // namespace rt::lang
