#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/things/block_evaluator.hpp"
#include "lang/evaluate/things/thing_evaluator.hpp"
#include "renderer/math/hashing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

scene::Combination::Operation operation(Op op) {
  using Operation = scene::Combination::Operation;
  return op == Op::unite ? Operation::unite : op == Op::intersect ? Operation::intersect : Operation::subtract;
}

} // namespace

Target target_for(Content& content, const NodeType& type, Span owner) {
  Target target;
  target.kind = Target::Kind::content;
  target.objects = &content.members;
  target.lights = &content.lights;
  target.type = &type;
  target.owner = owner;
  return target;
}

// a | b | c is a single union of three, not a union within a union; likewise a & b & c, and a - b - c.
Value ThingEvaluator::combine(Op op, const Value& left, const Value& right, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  if (errors_.is_unsure()) return Value::poison();
  const NodeType& type = program_.types.combination(operation(op));
  Ref<Thing> thing = make_thing(heap_, type, ast.span(node));
  thing->content = Ref<Content>(heap_.make<Content>(0));
  Target target = target_for(*thing->content, type, thing->span);
  const bool goes_on = left.is(ValueKind::thing) && left.thing().type == &type && left.thing().properties.empty() &&
                       !left.thing().chain && left.thing().content;
  if (goes_on) {
    Content& old = *left.thing().content;
    const bool is_last_use = left.cell()->references == 1 && old.references == 1 && !old.shape;
    if (is_last_use) std::swap(thing->content->members, old.members); // nobody else reads it
    begin_with_operands(old, is_last_use, *thing->content, target);
  } else {
    add_operand(left, ast.span(ast.left(node)), target);
  }
  add_operand(right, ast.span(ast.right(node)), target);
  finish_content(*thing->content, type, target, thing->span);
  set_depth(*thing, thing->span);
  return errors_.report().has_errors() && thing->content->is_nothing && !thing->content->is_cut ? Value::poison()
                                                                                                : Value(thing);
}

void ThingEvaluator::begin_with_operands(const Content& old, bool has_members, Content& content, Target& target) {
  Content members;
  begin_with(old, *target.type, members, target);
  if (has_members)
    target.things = static_cast<std::uint32_t>(content.members.size()) + (old.is_cut ? 1U : 0U);
  else
    content.members = std::move(members.members);
}

void ThingEvaluator::add_operand(const Value& value, Span place, Target& target) {
  if (value.is(ValueKind::thing)) {
    const Thing& thing = value.thing();
    if (thing.type->is_shape() || thing.type->category == Category::light) return put(thing, target);
    fail(errors::wrong_operand(place, fmt::format("{} is not a solid, so it cannot be combined", describe(value))));
    return;
  }
  // A list is the union of its elements.
  const NodeType& type = program_.types.combination(scene::Combination::Operation::unite);
  Ref<Thing> whole = make_thing(heap_, type, place);
  whole->content = Ref<Content>(heap_.make<Content>(0));
  Target inner = target_for(*whole->content, type, place);
  blocks_.put(value, place, inner);
  finish_content(*whole->content, type, inner, place);
  put(*whole, target);
}

Ref<Content> ThingEvaluator::content_cell(const Thing& thing) {
  if (thing.content) return thing.content;
  Ref<Content> made(heap_.make<Content>(0));
  made->is_pending = thing.def != nullptr;
  made->is_nothing = true;
  return made;
}

// A composite's contents; those of a def are made here, when first needed.
Ref<Content> ThingEvaluator::content(const Thing& thing) {
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
  Ref<Thing> key = make_thing(heap_, *thing.type, thing.span);
  key->def = thing.def;
  key->def_frame = thing.def_frame;
  key->content = thing.content;
  for (const PropertyValue& p : thing.properties) {
    if ((p.id & parameter_bit) != 0) key->properties.push_back(p);
  }
  instances_.emplace(h.value(), std::move(key));
  return thing.content;
}

bool ThingEvaluator::is_same_instance(const Thing& known, const Thing& thing) {
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

void ThingEvaluator::run_def(const Thing& thing, Content& content) {
  const FunctionInfo& def = *thing.def;
  content.is_pending = false;
  const ErrorReporter::TracedCall call(errors_, def, thing.span);
  const LimitGuard::NestedCall depth(limits_, thing.span);
  const FrameScope frame(evaluation_.frames, make_frame(heap_, thing.def_frame, def.frame_size));
  bool is_fine = true;
  for (const PropertyValue& p : thing.properties) {
    if ((p.id & parameter_bit) == 0) continue;
    (*frame.get())[def.parameters[static_cast<std::size_t>(p.id ^ parameter_bit)].slot] = p.value;
    is_fine &= !p.value.is_poison();
  }
  if (is_fine && expressions_.fill_defaults(def, *frame.get(), thing.span)) {
    def.was_run = true;
    PropertyBlock gathered{thing.type, nullptr, {}, {}, false};
    Target target = target_for(content, *thing.type, thing.span);
    target.properties = &gathered;
    blocks_.items(def.body, {def.unit, frame.get()}, target);
    content.defaults = std::move(gathered.values);
    content.depth = target.depth;
    finish_content(content, *thing.type, target, thing.span);
  }
}

void ThingEvaluator::finish_content(Content& content, const NodeType& type, const Target& target, Span place) {
  using Operation = scene::Combination::Operation;
  evaluation_.may_have_unused = true;
  content.depth = static_cast<std::uint16_t>(target.depth + 1);
  limits_.check_depth(content.depth, place);
  content.members.shrink_to_fit();
  // Subtracting from nothing gives nothing, and so does intersecting with nothing.
  content.is_cut =
      type.category == Category::combination && ((type.operation == Operation::subtract && target.is_first_missing) ||
                                                 (type.operation == Operation::intersect && target.is_one_missing));
  if (content.is_cut) content.members.clear();
  content.is_nothing = content.members.empty();
}

// Continues from a composite's existing contents.
void ThingEvaluator::begin_with(const Content& old, const NodeType& type, Content& members, Target& target) {
  members.members = old.members;
  if (old.shape) members.members = parts(evaluation_.builder.scene.shapes, *old.shape);
  members.lights = old.lights;
  target.depth = static_cast<std::uint16_t>(old.depth > 0 ? old.depth - 1 : 0);
  target.things = static_cast<std::uint32_t>(members.members.size() + members.lights.size()) + (old.is_cut ? 1U : 0U);
  target.is_first_missing = target.is_one_missing = old.is_cut && type.category == Category::combination;
  limits_.spend(members.members.size(), target.owner);
}

} // namespace rt::lang
