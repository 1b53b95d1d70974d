#include "lang/check/errors/dialects.hpp"
#include "lang/evaluate/evaluator.hpp"
#include "lang/evaluate/evaluator_loops.hpp"
#include "lang/text/suggest.hpp"
#include "renderer/math/hashing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

/// Only the properties that all shapes have differ: the shape itself may be shared.
bool is_dress(const NodeType& type, std::uint16_t id) {
  return (id & parameter_bit) == 0 && type.properties[id].common != Common::none;
}

} // namespace

Ref<Thing> Evaluator::new_thing(const NodeType& type, Span place) {
  Ref<Thing> thing(heap_.make<Thing>(0));
  thing->type = &type;
  thing->span = place;
  return thing;
}

// The first name that it is kept under; a further one is another name for the same.
void Evaluator::give_name(Thing& thing, Symbol symbol) {
  if (thing.is_bound) return;
  thing.is_bound = true;
  thing.default_name = symbol;
}

scene::NameId Evaluator::default_name(Symbol symbol) {
  if (symbol == no_symbol) return scene::no_name;
  const auto i = static_cast<std::size_t>(symbol);
  if (i >= default_names_.size()) default_names_.resize(std::max(i + 1, program_.symbols.size()), scene::no_name);
  if (default_names_[i] == scene::no_name) default_names_[i] = builder_.name(name(symbol));
  return default_names_[i];
}

Ref<Thing> Evaluator::copy_of(const Thing& thing) {
  Ref<Thing> copy = new_thing(*thing.type, thing.span);
  copy->depth = thing.depth;
  copy->def = thing.def;
  copy->def_frame = thing.def_frame;
  copy->properties = thing.properties;
  copy->chain = thing.chain;
  copy->default_name = thing.default_name;
  if (thing.def && !thing.content) thing.content = content_cell(thing); // run once, for both
  copy->content = thing.content;
  if (thing.type->category == Category::shape) copy->shape = shared_shape(thing);
  return copy;
}

Value Evaluator::override_value(NodeId node, const Context& context) {
  if (context.ast()[node].extra > 0) return simple_thing(node, context);
  const Override parts = context.ast().override_(node);
  Value base = expression(parts.base, context);
  if (base.is(ValueKind::thing)) return changed_thing(std::move(base), node, context);
  if (base.is(ValueKind::record)) return changed_record(base.record(), node, context);
  Target nowhere; // mistakes in the block are found all the same
  ++unsure_;
  if (context.ast().kind(parts.block) == Kind::block) items(parts.block, context, nowhere);
  --unsure_;
  if (base.is_poison()) return base;
  const bool is_named = base.is(ValueKind::closure) || base.is(ValueKind::builtin) || base.is(ValueKind::module);
  return fail(is_named ? "E0210" : "E0304", context.ast().span(parts.base), "only a thing can be copied with changes",
              "this is " + describe(base));
}

void Evaluator::simple_properties(NodeId node, const Context& context, const NodeType& type, PropertyList& properties) {
  const Ast& ast = context.ast();
  for (const NodeId item : ast.children(ast.override_(node).block)) {
    const NodeId value_node = ast.named(item).value;
    PropertyValue& p = properties.add();
    p.id = static_cast<std::uint16_t>(ast[item].extra - 1);
    p.span = ast.span(value_node);
    p.value = expression(value_node, context);
    const Property& property = type.properties[p.id];
    if (property.type == PropertyType::material && p.value.is(ValueKind::record))
      p.value = as_material(p.value.record(), p.span);
    if (const auto mistake = check_value(property, p.value)) {
      tell(*mistake, p.span);
      p.value = Value::poison();
    }
  }
}

Value Evaluator::simple_thing(NodeId node, const Context& context) {
  const NodeType& type = program_.types[static_cast<std::size_t>(context.ast()[node].extra - 1)];
  PropertyList properties;
  simple_properties(node, context, type, properties);
  Ref<Thing> thing = new_thing(type, context.ast().span(node));
  const std::span<PropertyValue> values = properties.values();
  thing->properties.assign(std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
  set_depth(*thing, thing->span);
  return thing;
}

Value Evaluator::changed_thing(Value base, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Override parts = ast.override_(node);
  const Thing& old = base.thing();
  PropertyBlock gathered{old.type, old.def, old.properties, {}, false};
  Target target;
  target.properties = &gathered;
  target.owner = ast.span(parts.base);
  Content members; // what the block adds to a group or a combination
  const bool takes_things = old.type->is_composite() && !old.def;
  if (takes_things) {
    target.kind = Target::Kind::content;
    target.objects = &members.members;
    target.lights = &members.lights;
    target.type = old.type;
    if (old.content) begin_with(*old.content, *old.type, members, target);
  }
  const std::uint32_t had = target.things;
  if (ast.kind(parts.block) == Kind::block)
    items(parts.block, context, target);
  else
    gathered.is_broken = true;
  if (gathered.is_broken) return Value::poison();
  Ref<Thing> thing = new_thing(*old.type, ast.span(node));
  thing->def = old.def;
  thing->def_frame = old.def_frame;
  thing->chain = old.chain;
  thing->default_name = old.default_name;
  const bool keeps_inside =
      std::ranges::all_of(gathered.written, [&](const PropertyBlock::Written& w) { return is_dress(*old.type, w.id); });
  if (takes_things) {
    if (target.things == had) {
      thing->content = old.content;
    } else {
      thing->content = Ref<Content>(heap_.make<Content>(0));
      thing->content->members = std::move(members.members);
      thing->content->lights = std::move(members.lights);
      thing->content->depth = target.depth;
      finish_content(*thing->content, *old.type, target, thing->span);
    }
  } else if (keeps_inside && old.def) {
    if (!old.content) old.content = content_cell(old);
    thing->content = old.content;
  } else if (keeps_inside && old.type->category == Category::shape) {
    thing->shape = shared_shape(old);
  }
  thing->properties = std::move(gathered.values);
  set_depth(*thing, thing->span);
  return thing;
}

Value Evaluator::changed_record(const Record& base, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  std::vector<Record::RecordEntry> entries = base.entries;
  for (const NodeId item : ast.children(ast.override_(node).block)) {
    if (ast.kind(item) == Kind::error) return Value::poison();
    if (ast.kind(item) != Kind::property)
      return fail("E0405", ast.span(item), "a record holds fields, and nothing else");
    const Named field = ast.named(item);
    Record::RecordEntry entry{field.symbol, expression(field.value, context), ast.span(field.value),
                              ast.named_span(item, program_.symbols)};
    const auto old = std::ranges::find(entries, field.symbol, &Record::RecordEntry::name);
    if (old == entries.end())
      entries.push_back(std::move(entry));
    else
      *old = std::move(entry);
  }
  return make_record(heap_, std::move(entries));
}

void Evaluator::fail_unknown_material_property(const Record::RecordEntry& entry) {
  const NodeType& type = program_.types.material();
  const std::string_view word = name(entry.name);
  std::vector<std::string_view> names;
  for (const Property& property : type.properties) names.push_back(property.name);
  std::string label = dialect_property(word, &type);
  if (const auto guess = nearest(word, names); guess && label.empty())
    label = fmt::format("did you mean `{}`?", *guess);
  fail("E0204", entry.name_span, fmt::format("`material` has no property `{}`", word), std::move(label),
       fmt::format("`material` takes {}", fmt::join(names, ", ")));
}

Value Evaluator::as_material(const Record& record, Span place) {
  const NodeType& type = program_.types.material();
  Ref<Thing> thing = new_thing(type, place);
  bool is_fine = true;
  for (const Record::RecordEntry& entry : record.entries) {
    const auto id = type.find(entry.name);
    if (!id) {
      fail_unknown_material_property(entry);
      is_fine = false;
      continue;
    }
    if (const auto mistake = check_value(type.properties[*id], entry.value)) {
      tell(*mistake, entry.span);
      is_fine = false;
    }
    is_fine &= !entry.value.is_poison();
    thing->properties.push_back({entry.value, entry.span, *id});
  }
  return is_fine ? Value(thing) : Value::poison();
}

void Evaluator::set_depth(Thing& thing, Span place) {
  std::uint16_t deepest = thing.content ? thing.content->depth : 0;
  for (const PropertyValue& p : thing.properties) deepest = std::max(deepest, depth_of(p.value));
  thing.depth = static_cast<std::uint16_t>(deepest + 1);
  check_depth(thing.depth, place);
}

Ref<Content> Evaluator::content_cell(const Thing& thing) {
  if (thing.content) return thing.content;
  Ref<Content> made(heap_.make<Content>(0));
  made->is_pending = thing.def != nullptr;
  made->is_nothing = true;
  return made;
}

// A composite's content; that of a def is made here, when it is needed first.
Ref<Content> Evaluator::content(const Thing& thing) {
  thing.content = content_cell(thing);
  if (!thing.content->is_pending) return thing.content;
  Hasher h;
  h.add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(thing.def)))
      .add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(thing.def_frame.get())));
  for (const PropertyValue& p : thing.properties) {
    if ((p.id & parameter_bit) != 0) h.add(hash(p.value) * (std::uint64_t{p.id} * 2 + 1));
  }
  const auto [begin, end] = instances_.equal_range(h.value());
  const auto found =
      std::find_if(begin, end, [&](const auto& entry) { return is_same_instance(*entry.second, thing); });
  if (found != end) {
    thing.content = found->second->content;
    return thing.content;
  }
  run_def(thing, *thing.content);
  if (instances_.size() >= most_instances) instances_.clear();
  Ref<Thing> key = new_thing(*thing.type, thing.span);
  key->def = thing.def;
  key->def_frame = thing.def_frame;
  key->content = thing.content;
  for (const PropertyValue& p : thing.properties) {
    if ((p.id & parameter_bit) != 0) key->properties.push_back(p);
  }
  instances_.emplace(h.value(), std::move(key));
  return thing.content;
}

bool Evaluator::is_same_instance(const Thing& known, const Thing& thing) {
  if (known.def != thing.def || known.def_frame != thing.def_frame) return false;
  std::size_t parameters = 0;
  for (const PropertyValue& p : thing.properties) {
    if ((p.id & parameter_bit) == 0) continue;
    ++parameters;
    const PropertyValue* other = known.find(p.id);
    if (!other || !equal(other->value, p.value)) return false;
  }
  return parameters == known.properties.size();
}

void Evaluator::run_def(const Thing& thing, Content& content) {
  const FunctionInfo& def = *thing.def;
  content.is_pending = false;
  const CallFrame call{&def, thing.span, calls_};
  calls_ = &call;
  enter_call(thing.span);
  const FrameScope frame(*this, make_frame(heap_, thing.def_frame, def.frame_size));
  bool is_fine = true;
  for (const PropertyValue& p : thing.properties) {
    if ((p.id & parameter_bit) == 0) continue;
    (*frame.get())[def.parameters[static_cast<std::size_t>(p.id ^ parameter_bit)].slot] = p.value;
    is_fine &= !p.value.is_poison();
  }
  if (is_fine && fill_defaults(def, *frame.get(), thing.span)) {
    def.was_run = true;
    PropertyBlock gathered{thing.type, nullptr, {}, {}, false};
    Target target;
    target.kind = Target::Kind::content;
    target.objects = &content.members;
    target.lights = &content.lights;
    target.type = thing.type;
    target.properties = &gathered;
    target.owner = thing.span;
    items(def.body, {def.unit, frame.get()}, target);
    content.defaults = std::move(gathered.values);
    content.depth = target.depth;
    finish_content(content, *thing.type, target, thing.span);
  }
  --recursion_;
  calls_ = call.caller;
}

void Evaluator::finish_content(Content& content, const NodeType& type, const Target& target, Span place) {
  using Operation = scene::Combination::Operation;
  has_leftovers_ = true;
  content.depth = static_cast<std::uint16_t>(target.depth + 1);
  check_depth(content.depth, place);
  content.members.shrink_to_fit();
  // What is cut out of nothing is nothing, and so is what something shares with nothing.
  content.is_cut =
      type.category == Category::combination && ((type.operation == Operation::subtract && target.is_first_missing) ||
                                                 (type.operation == Operation::intersect && target.is_one_missing));
  if (content.is_cut) content.members.clear();
  content.is_nothing = content.members.empty();
}

// Goes on from what a composite holds already.
void Evaluator::begin_with(const Content& old, const NodeType& type, Content& members, Target& target) {
  members.members = old.members;
  if (old.shape) members.members = parts(scene_.shapes, *old.shape);
  members.lights = old.lights;
  target.depth = static_cast<std::uint16_t>(old.depth > 0 ? old.depth - 1 : 0);
  target.things = static_cast<std::uint32_t>(members.members.size() + members.lights.size()) + (old.is_cut ? 1U : 0U);
  target.is_first_missing = target.is_one_missing = old.is_cut && type.category == Category::combination;
  spend(members.members.size(), target.owner);
}

} // namespace rt::lang
