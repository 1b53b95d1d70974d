#include "lang/evaluate/expressions/expression_evaluator.hpp"

#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/value_errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rt::lang {
namespace {

bool is_thing_or_list(const Value& value) {
  return value.is(ValueKind::thing) || value.is(ValueKind::list);
}

// The first name that it is bound to; further ones are aliases.
void give_name(Thing& thing, Symbol symbol) {
  if (thing.is_bound) return;
  thing.is_bound = true;
  thing.default_name = symbol;
}

} // namespace

Value ExpressionEvaluator::evaluate(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  switch (ast.kind(node)) {
  case Kind::number:
    return ast.number(node);
  case Kind::boolean:
    return Value::boolean(ast.boolean(node));
  case Kind::none:
    return {};
  case Kind::string:
    return make_string(heap_, std::string(ast.text(node)));
  case Kind::color:
    return from_srgb8(ast.color(node));
  case Kind::name:
    return name_value(node, context);
  case Kind::numbers:
  case Kind::list:
    return list_value(node, context);
  case Kind::record:
    return record_value(node, context);
  case Kind::comprehension:
    return comprehension_value(node, context);
  case Kind::lambda:
    return function_value(program_.functions[ast.function_index(node)], context.frame, ast.span(node));
  case Kind::call:
    return calls_.call_value(node, context);
  case Kind::index:
    return index_value(node, context);
  case Kind::member:
    return member_value(node, context);
  case Kind::override_:
    return things_.override_value(node, context);
  case Kind::unary:
    return unary_value(node, context);
  case Kind::binary:
    return binary_value(node, context);
  case Kind::range:
    return range_value(node, context);
  case Kind::if_:
    return if_value(node, context);
  case Kind::block:
    return value_block(node, context);
  default:
    return Value::poison(); // an error node, reported by the parser
  }
}

namespace {

Frame* outer(Frame* frame, std::size_t steps) {
  for (; steps > 0; --steps) frame = frame->parent.get();
  return frame;
}

} // namespace

Value ExpressionEvaluator::name_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const std::uint32_t index = ast.slot(node);
  switch (resolution(ast[node])) {
  case Resolution::local: {
    const Value& value = (*outer(context.frame, frames_out(ast[node])))[index];
    if (!value.is(ValueKind::unset)) return value;
    return fail(errors::no_value_yet(
        ast.span(node), fmt::format("`{}` has no value yet", name(ast.symbol(node))), "too early",
        {{std::nullopt, "a function may be called only after the lines that give the names in it their values"}}));
  }
  case Resolution::function:
    return function_value(program_.functions[index], outer(context.frame, frames_out(ast[node])), ast.span(node));
  case Resolution::type:
    return make_thing(heap_, program_.types[index], ast.span(node));
  case Resolution::builtin:
    return all_builtins()[index];
  case Resolution::constant:
    return constants()[index].value();
  case Resolution::color:
    return from_srgb8(index);
  case Resolution::choice:
    return Value::choice(program_.choices[index]);
  case Resolution::question: // is called, and never evaluated itself
  case Resolution::none:
    break;
  }
  return Value::poison();
}

Value ExpressionEvaluator::function_value(const FunctionInfo& function, Frame* frame, Span place) {
  if (function.kind != Kind::def) return Ref<Closure>(heap_.make<Closure>(0, function, Ref<Frame>(frame)));
  Ref<Thing> thing = make_thing(heap_, program_.types.group(), place);
  thing->def = &function;
  thing->def_frame = Ref<Frame>(frame);
  thing->default_name = function.name;
  return thing;
}

Value ExpressionEvaluator::list_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  if (ast.kind(node) == Kind::numbers) {
    const std::span<const double> numbers = ast.numbers(node);
    if (numbers.size() == 3) return Vec3{numbers[0], numbers[1], numbers[2]};
    if (numbers.size() == 2) return Value::point(numbers[0], numbers[1]);
    limits_.spend(numbers.size(), ast.span(node));
    return make_list(heap_, std::vector<Value>(numbers.begin(), numbers.end()));
  }
  const NodeList children = ast.children(node);
  if (children.size() == 3) { // most likely a vector: without an intermediate list
    Value x = evaluate(children[0], context), y = evaluate(children[1], context), z = evaluate(children[2], context);
    if (x.is_number() && y.is_number() && z.is_number()) return Vec3{x.number(), y.number(), z.number()};
    if (x.is_poison() || y.is_poison() || z.is_poison()) return Value::poison();
    std::vector<Value> items;
    for (Value* v : {&x, &y, &z}) items.push_back(std::move(*v));
    Value list = make_list(heap_, std::move(items));
    limits_.check_depth(depth_of(list), ast.span(node));
    return list;
  }
  limits_.spend(children.size(), ast.span(node));
  std::vector<Value> items;
  items.reserve(children.size());
  bool is_poison = false;
  for (const NodeId child : children) {
    items.push_back(evaluate(child, context));
    is_poison |= items.back().is_poison();
  }
  if (is_poison) return Value::poison();
  Value list = make_list(heap_, std::move(items));
  limits_.check_depth(depth_of(list), ast.span(node));
  return list;
}

Value ExpressionEvaluator::record_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  std::vector<Record::RecordEntry> entries;
  for (const NodeId item : ast.children(node)) {
    if (ast.kind(item) != Kind::property) return Value::poison();
    const Named field = ast.named(item);
    entries.push_back(
        {field.symbol, evaluate(field.value, context), ast.span(field.value), ast.named_span(item, program_.symbols)});
  }
  Value record = make_record(heap_, std::move(entries));
  limits_.check_depth(depth_of(record), ast.span(node));
  return record;
}

Value ExpressionEvaluator::comprehension_value(NodeId node, const Context& context) {
  std::vector<Value> items;
  Charge memory(heap_);
  comprehend(context.ast().comprehension(node), 0, context, items, memory);
  for (const Value& item : items) {
    if (item.is_poison()) return Value::poison();
  }
  Value list = make_list(heap_, std::move(items));
  limits_.check_depth(depth_of(list), context.ast().span(node));
  return list;
}

void ExpressionEvaluator::comprehend(const Comprehension& parts, std::size_t clause, const Context& context,
                                     std::vector<Value>& items, Charge& memory) {
  const Ast& ast = context.ast();
  if (clause == parts.clauses.size()) {
    memory.add(sizeof(Value));
    limits_.spend(1, ast.span(parts.element));
    items.push_back(evaluate(parts.element, context));
    return;
  }
  const NodeId node = parts.clauses[clause];
  if (ast.kind(node) == Kind::clause)
    return for_each(node, context, [&](const Context& inner) { comprehend(parts, clause + 1, inner, items, memory); });
  if (ast.kind(node) != Kind::filter) return items.push_back(Value::poison());
  bool is_poison = false;
  if (is_true(ast.operand(node), context, is_poison)) return comprehend(parts, clause + 1, context, items, memory);
  if (is_poison) items.push_back(Value::poison());
}

Value ExpressionEvaluator::range_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Range parts = ast.range(node);
  RangeValue range;
  double* const numbers[] = {&range.from, &range.to, &range.step};
  const NodeId nodes[] = {parts.from, parts.to, parts.step};
  bool is_poison = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (nodes[i] == no_node) continue;
    const Value value = evaluate(nodes[i], context);
    if (value.is_number())
      *numbers[i] = value.number();
    else if (ast.kind(nodes[i]) == Kind::range)
      return Value::poison(); // reported by the parser
    else if (!value.is_poison())
      fail(errors::wrong_operand(ast.span(nodes[i]), "a range is made of numbers", "this is " + describe(value)));
    is_poison |= !value.is_number();
  }
  if (is_poison) return Value::poison();
  if (range.step == 0)
    return fail(errors::range_stands_still(ast.span(parts.step), "the step of a range must not be 0"));
  for (std::size_t i = 0; i < 3; ++i) {
    if (nodes[i] != no_node && !std::isfinite(*numbers[i]))
      return fail(errors::not_finite(ast.span(nodes[i]), "a range is made of finite numbers",
                                     "this is " + format_number(*numbers[i])));
  }
  return Value::range(range, parts.excludes_end);
}

bool ExpressionEvaluator::truth_of(const Value& value, NodeId condition, const Context& context, bool& is_poison) {
  if (value.is(ValueKind::boolean)) return value.truth();
  is_poison = true;
  if (!value.is_poison())
    fail(errors::no_condition(context.ast().span(condition), "a condition must be true or false",
                              "this is " + describe(value)));
  return false;
}

Value ExpressionEvaluator::if_value(NodeId node, const Context& context) {
  const IfNode branch = context.ast().if_node(node);
  const Value value = evaluate(branch.condition, context);
  if (is_formula(value, FormulaType::boolean)) return choice_value(value, node, context);
  bool is_poison = false;
  const bool condition = truth_of(value, branch.condition, context, is_poison);
  if (is_poison) { // both may hold mistakes of their own
    const ErrorReporter::Unsure unsure(errors_);
    evaluate(branch.then, context);
    if (branch.otherwise != no_node) evaluate(branch.otherwise, context);
    return Value::poison();
  }
  if (condition) return evaluate(branch.then, context);
  return branch.otherwise == no_node ? Value::poison() : evaluate(branch.otherwise, context);
}

// Both branches are evaluated: which of them counts is known only at a point.
Value ExpressionEvaluator::choice_value(const Value& condition, NodeId node, const Context& context) {
  const IfNode branch = context.ast().if_node(node);
  const Value then = evaluate(branch.then, context);
  const Value otherwise = branch.otherwise == no_node ? Value::poison() : evaluate(branch.otherwise, context);
  if (then.is_poison() || otherwise.is_poison()) return Value::poison();
  return formulas_.choice(condition, then, otherwise, context.ast().span(node));
}

void ExpressionEvaluator::declare(NodeId item, const Context& context) {
  const Ast& ast = context.ast();
  switch (ast.kind(item)) {
  case Kind::bind: {
    const BindItem bind = ast.bind_item(item);
    Value value = evaluate(bind.value, context);
    if (value.is(ValueKind::thing)) give_name(value.thing(), ast.symbol(bind.name));
    (*context.frame)[ast.slot(bind.name)] = std::move(value);
    return;
  }
  case Kind::use:
    (*context.frame)[ast.slot(ast.use_item(item).name)] = things_.declared_value(item, context);
    return;
  case Kind::param:
    (*context.frame)[ast.slot(ast.param_item(item).name)] = things_.declared_value(item, context);
    return;
  default:
    return; // def and fn are names without a value
  }
}

Value ExpressionEvaluator::value_block(NodeId block, const Context& context) {
  const Ast& ast = context.ast();
  Value result = Value::poison(); // if a value is missing, check has reported it
  for (const NodeId item : ast.children(block)) {
    switch (ast.kind(item)) {
    case Kind::bind:
    case Kind::use:
    case Kind::param:
    case Kind::def:
    case Kind::fn:
      declare(item, context);
      break;
    case Kind::include:
      if (Unit* included = context.unit->included(item)) value_block(included->ast.root, {included, context.frame});
      break;
    case Kind::property:
    case Kind::for_:
      break;
    default:
      result = evaluate(item, context);
    }
  }
  return result;
}

Value ExpressionEvaluator::unary_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const NodeId operand = ast.operand(node);
  if (ast.op(node) == Op::not_) {
    const Value value = evaluate(operand, context);
    if (is_formula(value, FormulaType::boolean)) return formulas_.negation(value, ast.span(node));
    bool is_poison = false;
    const bool truth = truth_of(value, operand, context, is_poison);
    return is_poison ? Value::poison() : Value::boolean(!truth);
  }
  const Value value = evaluate(operand, context);
  return value.is_poison() ? value : operators_.with_sign(ast.op(node), value, ast.span(node));
}

Value ExpressionEvaluator::logic_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Value first = evaluate(ast.left(node), context);
  if (is_formula(first, FormulaType::boolean)) {
    const Value second = evaluate(ast.right(node), context);
    return second.is_poison() ? second : formulas_.logic(ast.op(node), first, second, ast.span(ast.right(node)));
  }
  bool is_poison = false;
  const bool left = truth_of(first, ast.left(node), context, is_poison);
  if (is_poison) {
    const ErrorReporter::Unsure unsure(errors_);
    evaluate(ast.right(node), context);
    return Value::poison();
  }
  const bool decides = ast.op(node) == Op::or_;
  if (left == decides) return Value::boolean(decides);
  const Value second = evaluate(ast.right(node), context);
  if (is_formula(second, FormulaType::boolean)) return second;
  const bool right = truth_of(second, ast.right(node), context, is_poison);
  return is_poison ? Value::poison() : Value::boolean(right);
}

Value ExpressionEvaluator::binary_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Op op = ast.op(node);
  if (op == Op::and_ || op == Op::or_) return logic_value(node, context);
  Value left = evaluate(ast.left(node), context);
  Value right = evaluate(ast.right(node), context);
  if (left.is_number() && right.is_number() && op >= Op::add && op != Op::unite && op != Op::intersect)
    return Operators::compute(op, left.number(), right.number());
  if (left.is_poison() || right.is_poison()) return Value::poison();
  if (is_solid_operator(op) && (left.is(ValueKind::thing) || right.is(ValueKind::thing) || op != Op::subtract) &&
      is_thing_or_list(left) && is_thing_or_list(right))
    return things_.combine(op, std::move(left), std::move(right), node, context);
  return operators_.binary(op, left, right, ast.span(node));
}

bool ExpressionEvaluator::is_loop_head(const Value& head, NodeId node, const Context& context) {
  if (head.is_poison()) return false;
  const Span place = context.ast().span(node);
  if (!is_sequence(head)) {
    fail(errors::not_iterable(place, "`for` iterates over a list or a range", "this is " + describe(head)));
    return false;
  }
  if (!head.is(ValueKind::range)) return true;
  const double n = count(head.range(), head.excludes_end());
  limits_.spend_if_too_many(n, place);
  if (n == 0 && head.range().to < head.range().from && context.ast().kind(node) == Kind::range &&
      context.ast().range(node).step == no_node) {
    errors_.report().add(errors::empty_range(place));
  }
  return true;
}

} // namespace rt::lang
