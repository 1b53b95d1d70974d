#include "lang/evaluate/evaluator.hpp"
#include "lang/evaluate/evaluator_loops.hpp"
#include "lang/text/suggest.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang {

Value Evaluator::expression(NodeId node, const Context& context) {
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
    return function_value(program_.functions[function_index(ast[node])], context.frame, ast.span(node));
  case Kind::call:
    return call_value(node, context);
  case Kind::index:
    return index_value(node, context);
  case Kind::member:
    return member_value(node, context);
  case Kind::override_:
    return override_value(node, context);
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

Value Evaluator::name_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const std::uint32_t index = ast.slot(node);
  switch (resolution(ast[node])) {
  case Resolution::local: {
    const Value& value = (*outer(context.frame, frames_out(ast[node])))[index];
    if (!value.is(ValueKind::unset)) return value;
    return fail("E0203", ast.span(node), fmt::format("`{}` has no value yet", name(ast.symbol(node))), "too early",
                "a function may be called only after the lines that give the names in it their values");
  }
  case Resolution::function:
    return function_value(program_.functions[index], outer(context.frame, frames_out(ast[node])), ast.span(node));
  case Resolution::type:
    return new_thing(program_.types[index], ast.span(node));
  case Resolution::builtin:
    return all_builtins()[index];
  case Resolution::constant:
    return constants()[index].value();
  case Resolution::color:
    return from_srgb8(index);
  case Resolution::choice:
    return Value::choice(program_.choices[index]);
  case Resolution::question: // is called, and then not asked for its value
  case Resolution::none:
    break;
  }
  return Value::poison();
}

Value Evaluator::function_value(const FunctionInfo& function, Frame* frame, Span place) {
  if (function.kind != Kind::def) return Ref<Closure>(heap_.make<Closure>(0, function, Ref<Frame>(frame)));
  Ref<Thing> thing = new_thing(program_.types.group(), place);
  thing->def = &function;
  thing->def_frame = Ref<Frame>(frame);
  thing->default_name = function.name;
  return thing;
}

Value Evaluator::list_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  if (ast.kind(node) == Kind::numbers) {
    const std::span<const double> numbers = ast.numbers(node);
    if (numbers.size() == 3) return Vec3{numbers[0], numbers[1], numbers[2]};
    if (numbers.size() == 2) return Value::point(numbers[0], numbers[1]);
    spend(numbers.size(), ast.span(node));
    return make_list(heap_, std::vector<Value>(numbers.begin(), numbers.end()));
  }
  const NodeList children = ast.children(node);
  if (children.size() == 3) { // a vector, most likely: without a list in between
    Value x = expression(children[0], context), y = expression(children[1], context),
          z = expression(children[2], context);
    if (x.is_number() && y.is_number() && z.is_number()) return Vec3{x.number(), y.number(), z.number()};
    if (x.is_poison() || y.is_poison() || z.is_poison()) return Value::poison();
    std::vector<Value> items;
    for (Value* v : {&x, &y, &z}) items.push_back(std::move(*v));
    Value list = make_list(heap_, std::move(items));
    check_depth(depth_of(list), ast.span(node));
    return list;
  }
  spend(children.size(), ast.span(node));
  std::vector<Value> items;
  items.reserve(children.size());
  bool is_poison = false;
  for (const NodeId child : children) {
    items.push_back(expression(child, context));
    is_poison |= items.back().is_poison();
  }
  if (is_poison) return Value::poison();
  Value list = make_list(heap_, std::move(items));
  check_depth(depth_of(list), ast.span(node));
  return list;
}

Value Evaluator::record_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  std::vector<Record::RecordEntry> entries;
  for (const NodeId item : ast.children(node)) {
    if (ast.kind(item) != Kind::property) return Value::poison();
    const Named field = ast.named(item);
    entries.push_back({field.symbol, expression(field.value, context), ast.span(field.value),
                       ast.named_span(item, program_.symbols)});
  }
  Value record = make_record(heap_, std::move(entries));
  check_depth(depth_of(record), ast.span(node));
  return record;
}

Value Evaluator::comprehension_value(NodeId node, const Context& context) {
  std::vector<Value> items;
  Charge memory(heap_);
  comprehend(context.ast().comprehension(node), 0, context, items, memory);
  for (const Value& item : items) {
    if (item.is_poison()) return Value::poison();
  }
  Value list = make_list(heap_, std::move(items));
  check_depth(depth_of(list), context.ast().span(node));
  return list;
}

void Evaluator::comprehend(const Comprehension& parts, std::size_t clause, const Context& context,
                           std::vector<Value>& items, Charge& memory) {
  const Ast& ast = context.ast();
  if (clause == parts.clauses.size()) {
    memory.add(sizeof(Value));
    spend(1, ast.span(parts.element));
    items.push_back(expression(parts.element, context));
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

Value Evaluator::index_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Index parts = ast.index(node);
  const Value base = expression(parts.base, context);
  const Value index = expression(parts.index, context);
  if (base.is_poison() || index.is_poison()) return Value::poison();
  if (!is_sequence(base))
    return fail("E0304", ast.span(parts.base), "only a list has elements", "this is " + describe(base));
  if (!index.is_number())
    return fail("E0304", ast.span(parts.index), "the place in a list is a number", "this is " + describe(index));
  const double size =
      base.is(ValueKind::range) ? count(base.range(), base.excludes_end()) : static_cast<double>(sequence_size(base));
  const double i = index.number();
  if (i != std::floor(i))
    return fail("E0308", ast.span(parts.index), "the place in a list is a whole number", "this is " + format_number(i));
  if (!(i >= -size && i < size)) {
    return fail("E0308", ast.span(parts.index), fmt::format("there is no element {}", format_number(i)),
                fmt::format("the list has {}, counted from 0", format_number(size)));
  }
  return sequence_at(base, static_cast<std::size_t>(i < 0 ? i + size : i));
}

Value Evaluator::member_value(NodeId node, const Context& context) {
  const Value base = expression(context.ast().member(node).base, context);
  return base.is_poison() ? base : member_of(base, node, context);
}

Value Evaluator::member_of(const Value& base, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Symbol symbol = ast.member(node).symbol;
  const std::string_view word = name(symbol);
  const Span place = ast.member_span(node, program_.symbols);
  const auto unknown = [&](std::string message, std::span<const std::string_view> names) {
    if (const auto guess = nearest(word, names))
      return fail("E0212", place, std::move(message), fmt::format("did you mean `{}`?", *guess));
    const bool is_function =
        std::ranges::any_of(all_builtins(), [&](const Builtin* builtin) { return builtin->name == word; });
    return fail("E0212", place, std::move(message),
                is_function ? fmt::format("a function stands in front: `{}(…)`", word) : "");
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
    return Value::poison(); // check has said so
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
  case ValueKind::thing:
    return thing_member(base.thing(), node, context);
  default:
    return unknown(fmt::format("{} has no part `{}`", describe(base), word), {});
  }
}

Value Evaluator::thing_member(const Thing& thing, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Symbol symbol = ast.member(node).symbol;
  const std::string_view word = name(symbol);
  const Span place = ast.member_span(node, program_.symbols);
  if (thing.def) {
    if (const auto i = thing.def->find(symbol)) {
      if (const PropertyValue* found = thing.find(parameter_id(*i))) return found->value;
      return fail("E0212", place, fmt::format("`{}` was not written for this thing", word),
                  "only written parameters can be read");
    }
  }
  if (const auto id = thing.type->find(symbol)) {
    if (const PropertyValue* found = thing.find(*id)) return found->value;
    if (const auto value = default_value(*thing.type, thing.type->properties[*id])) return *value;
    return fail("E0212", place, fmt::format("`{}` was not written for this thing", word), "it has no value");
  }
  if (find_chain_method(word))
    return fail("E0212", place, fmt::format("`.{}` needs its arguments", word), fmt::format("write `.{}(…)`", word));
  std::vector<std::string_view> names;
  for (const Property& property : thing.type->properties) names.push_back(property.name);
  const auto guess = nearest(word, names);
  return fail("E0212", place,
              fmt::format("{} has no property `{}`", describe(Value(Ref<Thing>(const_cast<Thing*>(&thing)))), word),
              guess ? fmt::format("did you mean `{}`?", *guess) : "");
}

Value Evaluator::range_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Range parts = ast.range(node);
  RangeValue range;
  double* const numbers[] = {&range.from, &range.to, &range.step};
  const NodeId nodes[] = {parts.from, parts.to, parts.step};
  bool is_poison = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (nodes[i] == no_node) continue;
    const Value value = expression(nodes[i], context);
    if (value.is_number())
      *numbers[i] = value.number();
    else if (ast.kind(nodes[i]) == Kind::range)
      return Value::poison(); // the parser has said so
    else if (!value.is_poison())
      fail("E0304", ast.span(nodes[i]), "a range is made of numbers", "this is " + describe(value));
    is_poison |= !value.is_number();
  }
  if (is_poison) return Value::poison();
  if (range.step == 0) return fail("E0311", ast.span(parts.step), "the step of a range must not be 0");
  for (std::size_t i = 0; i < 3; ++i) {
    if (nodes[i] != no_node && !std::isfinite(*numbers[i]))
      return fail("E0303", ast.span(nodes[i]), "a range is made of finite numbers",
                  "this is " + format_number(*numbers[i]));
  }
  return Value::range(range, parts.excludes_end);
}

bool Evaluator::is_true(NodeId condition, const Context& context, bool& is_poison) {
  const Value value = expression(condition, context);
  if (value.is(ValueKind::boolean)) return value.truth();
  is_poison = true;
  if (!value.is_poison())
    fail("E0305", context.ast().span(condition), "a condition is true or false", "this is " + describe(value));
  return false;
}

Value Evaluator::if_value(NodeId node, const Context& context) {
  const IfNode branch = context.ast().if_node(node);
  bool is_poison = false;
  const bool condition = is_true(branch.condition, context, is_poison);
  if (is_poison) { // both may hold mistakes of their own
    ++unsure_;
    expression(branch.then, context);
    if (branch.otherwise != no_node) expression(branch.otherwise, context);
    --unsure_;
    return Value::poison();
  }
  if (condition) return expression(branch.then, context);
  return branch.otherwise == no_node ? Value::poison() : expression(branch.otherwise, context);
}

void Evaluator::declaration(NodeId item, const Context& context) {
  const Ast& ast = context.ast();
  switch (ast.kind(item)) {
  case Kind::bind: {
    const BindItem bind = ast.bind_item(item);
    Value value = expression(bind.value, context);
    if (value.is(ValueKind::thing)) give_name(value.thing(), ast.symbol(bind.name));
    (*context.frame)[ast.slot(bind.name)] = std::move(value);
    return;
  }
  case Kind::use:
    (*context.frame)[ast.slot(ast.use_item(item).name)] = module_value(context, item);
    return;
  case Kind::param:
    (*context.frame)[ast.slot(ast.param_item(item).name)] = param_value(context, item);
    return;
  default:
    return; // def and fn are names without a value
  }
}

Value Evaluator::value_block(NodeId block, const Context& context) {
  const Ast& ast = context.ast();
  Value result = Value::poison(); // where a value is missing, check has said so
  for (const NodeId item : ast.children(block)) {
    switch (ast.kind(item)) {
    case Kind::bind:
    case Kind::use:
    case Kind::param:
    case Kind::def:
    case Kind::fn:
      declaration(item, context);
      break;
    case Kind::include:
      if (Unit* included = context.unit->included(item)) value_block(included->ast.root, {included, context.frame});
      break;
    case Kind::property:
    case Kind::for_:
      break;
    default:
      result = expression(item, context);
    }
  }
  return result;
}

} // namespace rt::lang
