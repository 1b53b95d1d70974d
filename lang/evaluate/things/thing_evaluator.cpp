#include "lang/evaluate/things/thing_evaluator.hpp"

#include "lang/check/errors/dialects.hpp"
#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/things/block_evaluator.hpp"
#include "lang/values/property_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

/// If only the properties common to all shapes differ, the shape itself may be shared.
bool is_common(const NodeType& type, std::uint16_t id) {
  return (id & parameter_bit) == 0 && type.properties[id].common != Common::none;
}

} // namespace

Ref<Thing> ThingEvaluator::copy_of(const Thing& thing) {
  Ref<Thing> copy = make_thing(heap_, *thing.type, thing.span);
  copy->depth = thing.depth;
  copy->def = thing.def;
  copy->def_frame = thing.def_frame;
  copy->properties = thing.properties;
  copy->chain = thing.chain;
  copy->default_name = thing.default_name;
  if (thing.def && !thing.content) thing.content = content_cell(thing); // run once, for both
  copy->content = thing.content;
  if (thing.type->category == Category::shape) copy->shape = writer_.shared_shape(thing);
  return copy;
}

Value ThingEvaluator::override_value(NodeId node, const Context& context) {
  if (context.ast()[node].extra > 0) return simple_thing(node, context);
  const Override parts = context.ast().override_(node);
  Value base = expressions_.evaluate(parts.base, context);
  if (base.is(ValueKind::thing)) return changed_thing(base.thing(), node, context);
  if (base.is(ValueKind::record)) return changed_record(base.record(), node, context);
  if (context.ast().kind(parts.block) == Kind::block) { // errors in it are found regardless
    Target nowhere;
    const ErrorReporter::Unsure unsure(errors_);
    blocks_.items(parts.block, context, nowhere);
  }
  if (base.is_poison()) return base;
  const bool is_named = base.is(ValueKind::closure) || base.is(ValueKind::builtin) || base.is(ValueKind::module);
  const Span place = context.ast().span(parts.base);
  const std::string message = "only a thing can be copied with changes", label = "this is " + describe(base);
  return fail(is_named ? errors::no_thing(place, message, label) : errors::wrong_operand(place, message, label));
}

void ThingEvaluator::simple_properties(NodeId node, const Context& context, const NodeType& type,
                                       PropertyList& properties) {
  const Ast& ast = context.ast();
  for (const NodeId item : ast.children(ast.override_(node).block)) {
    const NodeId value_node = ast.named(item).value;
    PropertyValue& p = properties.add();
    p.id = static_cast<std::uint16_t>(ast[item].extra - 1);
    p.span = ast.span(value_node);
    p.value = expressions_.evaluate(value_node, context);
    prepare(type.properties[p.id], p.value, p.span);
  }
}

void ThingEvaluator::prepare(const Property& property, Value& value, Span place) {
  if (property.type == PropertyType::material && value.is(ValueKind::record))
    value = as_material(value.record(), place);
  const auto compile = [&](const Value& function) {
    if (is_function(function) && takes_function(property) &&
        !compiler_.compile(function.closure(), property.name, place))
      value = Value::poison();
  };
  compile(value);
  if (property.type == PropertyType::stops && is_sequence(value) && !value.is(ValueKind::range)) {
    for (std::size_t i = 0; i < sequence_size(value) && !value.is_poison(); ++i)
      if (const std::optional<StopParts> stop = as_stop(sequence_at(value, i))) compile(stop->shown);
  }
  if (auto mistake = check_value(property, value)) {
    mistake->span = place;
    value = fail(*std::move(mistake));
  }
}

Value ThingEvaluator::simple_thing(NodeId node, const Context& context) {
  const NodeType& type = program_.types[static_cast<std::size_t>(context.ast()[node].extra - 1)];
  PropertyList properties;
  simple_properties(node, context, type, properties);
  Ref<Thing> thing = make_thing(heap_, type, context.ast().span(node));
  const std::span<PropertyValue> values = properties.values();
  thing->properties.assign(std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
  set_depth(*thing, thing->span);
  return thing;
}

Value ThingEvaluator::changed_thing(const Thing& old, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Override parts = ast.override_(node);
  PropertyBlock block{old.type, old.def, old.properties, {}, false};
  Content members; // what the block adds to a group or a combination
  const bool takes_things = old.type->is_composite() && !old.def;
  Target target;
  if (takes_things) target = target_for(members, *old.type, {});
  target.properties = &block;
  target.owner = ast.span(parts.base);
  if (takes_things && old.content) begin_with(*old.content, *old.type, members, target);
  const std::uint32_t had = target.things;
  if (ast.kind(parts.block) == Kind::block)
    blocks_.items(parts.block, context, target);
  else
    block.is_broken = true;
  if (block.is_broken) return Value::poison();
  Ref<Thing> thing = make_thing(heap_, *old.type, ast.span(node));
  thing->def = old.def;
  thing->def_frame = old.def_frame;
  thing->chain = old.chain;
  thing->default_name = old.default_name;
  if (!takes_things) {
    share_inside(old, block, *thing);
  } else if (target.things == had) {
    thing->content = old.content;
  } else {
    thing->content = Ref<Content>(heap_.make<Content>(0));
    thing->content->members = std::move(members.members);
    thing->content->lights = std::move(members.lights);
    thing->content->depth = target.depth;
    finish_content(*thing->content, *old.type, target, thing->span);
  }
  thing->properties = std::move(block.values);
  set_depth(*thing, thing->span);
  return thing;
}

// If nothing is changed that its shape or contents depend on.
void ThingEvaluator::share_inside(const Thing& old, const PropertyBlock& block, Thing& thing) {
  const bool keeps_inside =
      std::ranges::all_of(block.written, [&](const PropertyBlock::Written& w) { return is_common(*old.type, w.id); });
  if (!keeps_inside) return;
  if (old.def) {
    if (!old.content) old.content = content_cell(old);
    thing.content = old.content;
  } else if (old.type->category == Category::shape) {
    thing.shape = writer_.shared_shape(old);
  }
}

Value ThingEvaluator::changed_record(const Record& base, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  std::vector<Record::RecordEntry> entries = base.entries;
  for (const NodeId item : ast.children(ast.override_(node).block)) {
    if (ast.kind(item) == Kind::error) return Value::poison();
    if (ast.kind(item) != Kind::property)
      return fail(errors::takes_no_things(ast.span(item), "a record contains only fields"));
    const Named field = ast.named(item);
    Record::RecordEntry entry{field.symbol, expressions_.evaluate(field.value, context), ast.span(field.value),
                              ast.named_span(item, program_.symbols)};
    const auto old = std::ranges::find(entries, field.symbol, &Record::RecordEntry::name);
    if (old == entries.end())
      entries.push_back(std::move(entry));
    else
      *old = std::move(entry);
  }
  return make_record(heap_, std::move(entries));
}

void ThingEvaluator::fail_unknown_material_property(const Record::RecordEntry& entry) {
  const NodeType& type = program_.types.material();
  const std::string_view word = name(entry.name);
  std::vector<std::string_view> names;
  for (const Property& property : type.properties) names.push_back(property.name);
  Diagnostic error = errors::no_property(entry.name_span, fmt::format("`material` has no property `{}`", word), {});
  advise_on_property(error, "`material`", word, type, names);
  fail(std::move(error));
}

Value ThingEvaluator::as_material(const Record& record, Span place) {
  const NodeType& type = program_.types.material();
  Ref<Thing> thing = make_thing(heap_, type, place);
  bool is_fine = true;
  for (const Record::RecordEntry& entry : record.entries) {
    const auto id = type.find(entry.name);
    if (!id) {
      fail_unknown_material_property(entry);
      is_fine = false;
      continue;
    }
    Value value = entry.value;
    prepare(type.properties[*id], value, entry.span);
    is_fine &= !value.is_poison();
    thing->properties.push_back({std::move(value), entry.span, *id});
  }
  return is_fine ? Value(thing) : Value::poison();
}

void ThingEvaluator::set_depth(Thing& thing, Span place) {
  std::uint16_t deepest = thing.content ? thing.content->depth : 0;
  for (const PropertyValue& p : thing.properties) deepest = std::max(deepest, depth_of(p.value));
  thing.depth = static_cast<std::uint16_t>(deepest + 1);
  limits_.check_depth(thing.depth, place);
}

void ThingEvaluator::put_simple(NodeId node, const Context& context, Target& target) {
  const NodeType& type = program_.types[static_cast<std::size_t>(context.ast()[node].extra - 1)];
  PropertyList properties;
  simple_properties(node, context, type, properties);
  writer_.put({&type, properties.values(), nullptr, context.ast().span(node), nullptr}, target);
}

void ThingEvaluator::put(const Thing& thing, Target& target) {
  ThingView described{thing.type, thing.properties, thing.chain.get(), thing.span, &thing};
  Ref<Content> inside; // keeps it alive while it is put
  if (thing.type->is_composite() && writer_.takes(described, target)) inside = content(thing);
  described.inside = inside.get();
  writer_.put(described, target);
}

Value ThingEvaluator::moved(const Thing& thing, scene::Step step, Span place) {
  Ref<Thing> copy = copy_of(thing);
  Ref<Chain> chain(heap_.make<Chain>(0));
  chain->steps.reserve((thing.chain ? thing.chain->steps.size() : 0) + 1);
  if (thing.chain) chain->steps = thing.chain->steps;
  limits_.spend(chain->steps.size(), place);
  chain->steps.push_back(std::move(step));
  copy->chain = std::move(chain);
  return copy;
}

} // namespace rt::lang
