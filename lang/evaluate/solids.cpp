#include "lang/evaluate/evaluator.hpp"
#include "renderer/scene/media_conflicts.hpp"

#include <fmt/format.h>

namespace rt::lang {
namespace {

scene::Combination::Operation operation(Op op) {
  using Operation = scene::Combination::Operation;
  return op == Op::unite ? Operation::unite : op == Op::intersect ? Operation::intersect : Operation::subtract;
}

} // namespace

// a | b | c is one union of three, not a union within a union; so are a & b & c, and a - b - c.
Value Evaluator::combine(Op op, Value left, Value right, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  if (unsure_ > 0) return Value::poison();
  const NodeType& type = program_.types.combination(operation(op));
  Ref<Thing> thing = new_thing(type, ast.span(node));
  thing->content = Ref<Content>(heap_.make<Content>(0));
  Target target;
  target.kind = Target::Kind::content;
  target.objects = &thing->content->members;
  target.lights = &thing->content->lights;
  target.type = &type;
  target.owner = thing->span;
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
  return report_.has_errors() && thing->content->is_nothing && !thing->content->is_cut ? Value::poison() : Value(thing);
}

void Evaluator::begin_with_operands(const Content& old, bool has_members, Content& content, Target& target) {
  Content members;
  begin_with(old, *target.type, members, target);
  if (has_members)
    target.things = static_cast<std::uint32_t>(content.members.size()) + (old.is_cut ? 1U : 0U);
  else
    content.members = std::move(members.members);
}

void Evaluator::add_operand(const Value& value, Span place, Target& target) {
  if (value.is(ValueKind::thing)) {
    const Thing& thing = value.thing();
    if (thing.type->is_shape() || thing.type->category == Category::light)
      return put_thing({thing.type, thing.properties, thing.chain.get(), thing.span, &thing}, target);
    fail("E0304", place, fmt::format("{} is no solid, so it cannot be combined", describe(value)));
    return;
  }
  // A list is the union of what is in it.
  const NodeType& type = program_.types.combination(scene::Combination::Operation::unite);
  Ref<Thing> whole = new_thing(type, place);
  whole->content = Ref<Content>(heap_.make<Content>(0));
  Target inner;
  inner.kind = Target::Kind::content;
  inner.objects = &whole->content->members;
  inner.lights = &whole->content->lights;
  inner.type = &type;
  inner.owner = place;
  put(value, place, inner);
  finish_content(*whole->content, type, inner, place);
  put_thing({whole->type, {}, nullptr, place, whole.get()}, target);
}

void Evaluator::check_media(const std::vector<scene::Object>& objects) {
  for (const scene::MediaConflict& conflict : media_conflicts(scene_, objects)) {
    fail("E0408", combination_places_[conflict.combination],
         "the parts of this solid refract differently, and one solid is one medium",
         fmt::format("`ior` is {} in one part and {} in another", format_number(conflict.first_ior),
                     format_number(conflict.second_ior)),
         "give the whole a material, or its parts the same `ior`");
  }
}

} // namespace rt::lang
