#include "lang/evaluate/evaluator.hpp"
#include "lang/evaluate/evaluator_loops.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt::lang {

void Evaluator::items(NodeId block, const Context& context, Target& target) {
  // By position: a file's own list of items does not change, but its nodes do, when repeats become one another.
  const NodeList children = context.ast().children(block);
  for (const NodeId child : children) item(child, context, target);
}

void Evaluator::item(NodeId node, const Context& context, Target& target) {
  const Ast& ast = context.ast();
  spend(1, {ast.file, ast[node].begin, ast[node].end});
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
    return declaration(node, context);
  case Kind::include:
    if (Unit* included = context.unit->included(node))
      file_items(included->ast.root, {included, context.frame}, target);
    return;
  case Kind::expect:
    if (make_observer_ && unsure_ == 0 && target.kind == Target::Kind::scene)
      expectations_.push_back({context.unit, node, Ref<Frame>(context.frame), turn_of_loops()});
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
    if (ast[node].extra > 0) return put_simple(node, context, target);
    break;
  default:
    break;
  }
  put(expression(node, context), ast.span(node), target);
}

void Evaluator::loop_items(NodeId node, const Context& context, Target& target) {
  const auto body = [&](const Context& inner) { items(inner.ast().for_item(node).body, inner, target); };
  if (!make_observer_) return for_each(node, context, body);
  for_each(node, context, [&](const Context& inner) {
    loops_.push_back({&inner.ast(), node, inner.frame});
    body(inner);
    loops_.pop_back();
  });
}

void Evaluator::repeat(NodeId node, const Context& context, Target& target) {
  Ast& ast = context.ast();
  const Repeat repeat = ast.repeat(node);
  if (target.objects && repeat.count > target.objects->size())
    target.objects->reserve(target.objects->size() + repeat.count);
  RepeatSpans model(report_, program_.sources, ast.model_span(repeat));
  for (std::uint32_t i = 0; i < repeat.count; ++i) {
    ast.become(repeat, i);
    model.stand_for(ast.item_span(repeat, i));
    item(repeat.model, context, target);
  }
}

void Evaluator::if_item(NodeId node, const Context& context, Target& target) {
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
  const bool condition = is_true(branch.condition, context, is_poison);
  if (!is_poison) return run(condition ? branch.then : branch.otherwise);
  ++unsure_;
  run(branch.then);
  run(branch.otherwise);
  --unsure_;
}

bool Evaluator::is_loop_head(const Value& head, NodeId node, const Context& context) {
  if (head.is_poison()) return false;
  const Span place = context.ast().span(node);
  if (!is_sequence(head)) {
    fail("E0307", place, "`for` goes through a list or a range", "this is " + describe(head));
    return false;
  }
  if (!head.is(ValueKind::range)) return true;
  const double n = count(head.range(), head.excludes_end());
  const auto left = static_cast<double>(limits_.steps - std::min(limits_.steps, steps_));
  if (n > left) spend(limits_.steps, place); // more than there are steps for, so they need not be counted one by one
  if (n == 0 && head.range().to < head.range().from && context.ast().kind(node) == Kind::range &&
      context.ast().range(node).step == no_node) {
    if (Diagnostic* d = report_.add(Severity::note, "N0003", place)) {
      d->message = "this range is empty: it runs upwards, and its end lies below its beginning";
      d->label = "to count down, write `by -1`";
    }
  }
  return true;
}

void Evaluator::property_item(NodeId node, const Context& context, Target& target) {
  const Ast& ast = context.ast();
  const Named property = ast.named(node);
  Value value = expression(property.value, context);
  PropertyBlock* gathered = target.properties;
  if (!gathered) return;
  const Span name_place = ast.named_span(node, program_.symbols);
  std::optional<std::uint16_t> id;
  if (ast[node].extra > 0 && !gathered->def) id = static_cast<std::uint16_t>(ast[node].extra - 1);
  if (!id && gathered->def) {
    if (const auto parameter = gathered->def->find(property.symbol)) id = parameter_id(*parameter);
  }
  if (!id) id = gathered->type->find(property.symbol);
  if (id) return set_property(*gathered, *id, std::move(value), ast.span(property.value), name_place);
  gathered->is_broken = true;
  if (Diagnostic* d = error("E0204", name_place)) {
    std::vector<std::string_view> names;
    if (gathered->def) {
      for (const FunctionInfo::Parameter& p : gathered->def->parameters) names.push_back(name(p.name));
    }
    for (const Property& p : gathered->type->properties) names.push_back(p.name);
    const std::string_view whose = gathered->def ? name(gathered->def->name) : gathered->type->name;
    const auto guess = nearest(name(property.symbol), names);
    d->message = fmt::format("`{}` has no property `{}`", whose, name(property.symbol));
    if (guess) d->label = fmt::format("did you mean `{}`?", *guess);
    d->notes.push_back({std::nullopt, fmt::format("`{}` takes {}", whose, fmt::join(names, ", "))});
  }
}

void Evaluator::set_property(PropertyBlock& gathered, std::uint16_t id, Value value, Span place, Span name_place) {
  const bool is_parameter = (id & parameter_bit) != 0;
  const Property* property = is_parameter ? nullptr : &gathered.type->properties[id];
  const std::string_view word = is_parameter ? name(gathered.def->parameters[id ^ parameter_bit].name) : property->name;
  if (property && property->type == PropertyType::material && value.is(ValueKind::record))
    value = as_material(value.record(), place);
  for (const PropertyBlock::Written& other : gathered.written) {
    const bool is_twice = other.id == id;
    const bool clashes = property && property->form != 0 && (other.id & parameter_bit) == 0 &&
                         gathered.type->properties[other.id].form != 0 &&
                         gathered.type->properties[other.id].form != property->form;
    if (!is_twice && !clashes) continue;
    if (Diagnostic* d = error(is_twice ? "E0205" : "E0206", name_place)) {
      d->message = is_twice ? fmt::format("`{}` is written twice", word)
                            : fmt::format("`{}` and `{}` are two ways to say the same",
                                          gathered.type->properties[other.id].name, word);
      if (clashes) d->label = "leave one of them out";
      d->notes.push_back({other.name, is_twice ? "first here" : "the other one is here"});
    }
    return;
  }
  if (property) {
    if (const auto mistake = check_value(*property, value)) {
      tell(*mistake, place);
      value = Value::poison();
    }
    if (property->form != 0) { // the form that is written drops the inherited other one
      std::erase_if(gathered.values, [&](const PropertyValue& p) {
        const int form = (p.id & parameter_bit) != 0 ? 0 : gathered.type->properties[p.id].form;
        return form != 0 && form != property->form;
      });
    }
  }
  gathered.written.push_back({id, name_place});
  for (PropertyValue& p : gathered.values) {
    if (p.id != id) continue;
    p.value = std::move(value);
    p.span = place;
    return;
  }
  gathered.values.push_back({std::move(value), place, id});
}

void Evaluator::put(const Value& value, Span place, Target& target) {
  switch (value.kind()) {
  case ValueKind::poison:
  case ValueKind::none:
    return;
  case ValueKind::thing: {
    const Thing& thing = value.thing();
    return put_thing({thing.type, thing.properties, thing.chain.get(), thing.span, &thing}, target);
  }
  case ValueKind::list:
    for (const Value& element : value.items()) {
      spend(1, place);
      put(element, place, target);
    }
    return;
  default:
    break;
  }
  if (target.kind == Target::Kind::discarded) return;
  if (Diagnostic* d = error("E0312", place)) {
    d->message = fmt::format("nothing is done with this: it is {}", describe(value));
    d->label = "a line holds a thing, a list of things or `none`";
    if (value.is(ValueKind::boolean)) d->notes.push_back({std::nullopt, "to bind a name, write a single `=`"});
    if (value.is(ValueKind::closure) || value.is(ValueKind::builtin))
      d->notes.push_back({std::nullopt, "a function is called with ( )"});
  }
}

void Evaluator::put_comprehension(const Comprehension& parts, std::size_t clause, const Context& context,
                                  Target& target) {
  const Ast& ast = context.ast();
  if (clause == parts.clauses.size()) {
    if (ast.kind(parts.element) == Kind::property) return;
    return item(parts.element, context, target);
  }
  const NodeId node = parts.clauses[clause];
  if (ast.kind(node) == Kind::clause)
    return for_each(node, context, [&](const Context& inner) { put_comprehension(parts, clause + 1, inner, target); });
  if (ast.kind(node) != Kind::filter) return;
  bool is_poison = false;
  if (is_true(ast.operand(node), context, is_poison)) return put_comprehension(parts, clause + 1, context, target);
  if (!is_poison) return;
  ++unsure_;
  put_comprehension(parts, clause + 1, context, target);
  --unsure_;
}

} // namespace rt::lang
