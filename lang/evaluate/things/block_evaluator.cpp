#include "lang/evaluate/things/block_evaluator.hpp"

#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/things/thing_evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang {

namespace {

/// The slot of the value of an item that binds a name.
std::optional<std::uint32_t> bound_slot(const Ast& ast, NodeId item) {
  switch (ast.kind(item)) {
  case Kind::bind:
    return ast.slot(ast.bind_item(item).name);
  case Kind::use:
    return ast.slot(ast.use_item(item).name);
  case Kind::param:
    return ast.slot(ast.param_item(item).name);
  default:
    return std::nullopt;
  }
}

} // namespace

void BlockEvaluator::items(NodeId block, const Context& context, Target& target) {
  // By index: a file's list of items does not change, but its nodes do, when repeats become one another.
  const NodeList children = context.ast().children(block);
  for (const NodeId child : children) item(child, context, target);
}

void BlockEvaluator::file_items(NodeId root, const Context& context, Target& target) {
  const NodeList children = context.ast().children(root);
  for (const NodeId child : children) {
    if (ends_in_time([&] { item(child, context, target); })) continue;
    if (const auto slot = bound_slot(context.ast(), child)) (*context.frame)[*slot] = Value::poison();
  }
}

void BlockEvaluator::item(NodeId node, const Context& context, Target& target) {
  const Ast& ast = context.ast();
  limits_.spend(1, {ast.file, ast[node].begin, ast[node].end});
  switch (ast.kind(node)) {
  case Kind::error:
    if (target.properties) target.properties->is_broken = true;
    return;
  case Kind::def:
  case Kind::fn:
    return;
  case Kind::bind:
  case Kind::use:
  case Kind::param:
    return expressions_.declare(node, context);
  case Kind::include:
    if (Unit* included = context.unit->included(node))
      file_items(included->ast.root, {included, context.frame}, target);
    return;
  case Kind::expect:
    if (expectations_.is_wanted() && !errors_.is_unsure() && target.kind == Target::Kind::scene)
      expectations_.add(context, node);
    return;
  case Kind::property:
    return property_item(node, context, target);
  case Kind::for_:
    return loop_items(node, context, target);
  case Kind::if_:
    return if_item(node, context, target);
  case Kind::repeat:
    return repeat(node, context, target);
  case Kind::comprehension:
    return put_comprehension(ast.comprehension(node), 0, context, target);
  case Kind::override_:
    if (ast[node].extra > 0) return things_.put_simple(node, context, target);
    break;
  default:
    break;
  }
  put(expressions_.evaluate(node, context), ast.span(node), target);
}

void BlockEvaluator::loop_items(NodeId node, const Context& context, Target& target) {
  const auto body = [&](const Context& inner) { items(inner.ast().for_item(node).body, inner, target); };
  if (!expectations_.is_wanted()) return expressions_.for_each(node, context, body);
  expressions_.for_each(node, context, [&](const Context& inner) {
    const ExpectationList::Turn turn(expectations_, inner, node);
    body(inner);
  });
}

void BlockEvaluator::repeat(NodeId node, const Context& context, Target& target) {
  Ast& ast = context.ast();
  const Repeat repeat = ast.repeat(node);
  if (target.objects && repeat.count > target.objects->size())
    target.objects->reserve(target.objects->size() + repeat.count);
  RepeatSpans model(errors_.report(), program_.sources, ast.model_span(repeat));
  for (std::uint32_t i = 0; i < repeat.count; ++i) {
    ast.become(repeat, i);
    model.stand_for(ast.item_span(repeat, i));
    item(repeat.model, context, target);
  }
}

void BlockEvaluator::if_item(NodeId node, const Context& context, Target& target) {
  const Ast& ast = context.ast();
  const IfNode branch = ast.if_node(node);
  const auto run = [&](NodeId body) {
    if (body == no_node) return;
    if (ast.kind(body) == Kind::if_)
      if_item(body, context, target);
    else if (ast.kind(body) == Kind::block)
      items(body, context, target);
  };
  bool is_poison = false;
  const bool condition = expressions_.is_true(branch.condition, context, is_poison);
  if (!is_poison) return run(condition ? branch.then : branch.otherwise);
  const ErrorReporter::Unsure unsure(errors_);
  run(branch.then);
  run(branch.otherwise);
}

void BlockEvaluator::put(const Value& value, Span place, Target& target) {
  switch (value.kind()) {
  case ValueKind::poison:
  case ValueKind::none:
    return;
  case ValueKind::thing:
    return things_.put(value.thing(), target);
  case ValueKind::list:
    for (const Value& element : value.items()) {
      limits_.spend(1, place);
      put(element, place, target);
    }
    return;
  default:
    break;
  }
  if (target.kind == Target::Kind::discarded) return;
  std::string advice;
  if (value.is(ValueKind::boolean)) advice = "to bind a name, write a single `=`";
  if (value.is(ValueKind::closure) || value.is(ValueKind::builtin)) advice = "a function is called with ( )";
  fail(errors::unused_value(place, fmt::format("this value is not used: it is {}", describe(value)),
                            "a statement is a thing, a list of things or `none`", std::move(advice)));
}

void BlockEvaluator::put_comprehension(const Comprehension& parts, std::size_t clause, const Context& context,
                                       Target& target) {
  const Ast& ast = context.ast();
  if (clause == parts.clauses.size()) {
    if (ast.kind(parts.element) == Kind::property) return;
    return item(parts.element, context, target);
  }
  const NodeId node = parts.clauses[clause];
  if (ast.kind(node) == Kind::clause)
    return expressions_.for_each(node, context,
                                 [&](const Context& inner) { put_comprehension(parts, clause + 1, inner, target); });
  if (ast.kind(node) != Kind::filter) return;
  bool is_poison = false;
  if (expressions_.is_true(ast.operand(node), context, is_poison))
    return put_comprehension(parts, clause + 1, context, target);
  if (!is_poison) return;
  const ErrorReporter::Unsure unsure(errors_);
  put_comprehension(parts, clause + 1, context, target);
}

} // namespace rt::lang
