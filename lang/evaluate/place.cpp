#include "lang/check/lint/rules.hpp"
#include "lang/evaluate/evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace rt::lang {
namespace {

/// Memory for a shape or light that is being made.
class Room {
public:
  explicit Room(const Maker& maker) : maker_(maker) { maker_.construct(memory_); }
  Room(const Room&) = delete;
  Room& operator=(const Room&) = delete;
  ~Room() { maker_.destroy(memory_); }
  void* get() { return memory_; }

private:
  const Maker& maker_;
  alignas(std::max_align_t) std::byte memory_[maker_room];
};

Span place_of(std::span<const PropertyValue> properties, const NodeType& type, std::string_view property,
              Span otherwise) {
  for (const PropertyValue& p : properties) {
    if ((p.id & parameter_bit) == 0 && type.properties[p.id].name == property) return p.span;
  }
  return otherwise;
}

} // namespace

bool Evaluator::is_poisoned(std::span<const PropertyValue> properties) {
  return std::ranges::any_of(properties, [](const PropertyValue& p) { return p.value.is_poison(); });
}

void Evaluator::put_simple(NodeId node, const Context& context, Target& target) {
  const NodeType& type = program_.types[static_cast<std::size_t>(context.ast()[node].extra - 1)];
  PropertyList properties;
  simple_properties(node, context, type, properties);
  put_thing({&type, properties.values(), nullptr, context.ast().span(node), nullptr}, target);
}

void Evaluator::put_thing(const ThingView& described, Target& target) {
  const NodeType& type = *described.type;
  if (target.kind == Target::Kind::discarded) return;
  if (target.kind == Target::Kind::bare) {
    if (!target.properties) return; // the block of something in error
    const NodeType& owner = *target.properties->type;
    const std::string_view whose = target.properties->def ? name(target.properties->def->name) : owner.name;
    fail("E0405", described.place, fmt::format("things cannot be put into `{}`", whose), {},
         "a `group` and the combinations take things; other blocks hold properties only");
    return;
  }
  switch (type.category) {
  case Category::shape:
  case Category::group:
  case Category::combination:
    return put_shape(described, target);
  case Category::light:
    return put_light(described, target);
  case Category::camera:
    return put_camera(described, target);
  default:
    break;
  }
  fail("E0410", described.place, fmt::format("a {} is not placed: it belongs to a shape", type.name), {},
       type.category == Category::material ? "keep it with `name = …`, or write it after `material:`"
                                           : "write it after `material:`, or as a material's `color`");
}

bool Evaluator::make(const ThingView& described, void* room) {
  const NodeType& type = *described.type;
  for (const PropertyValue& p : described.properties) {
    const Property& property = type.properties[p.id];
    if (property.common == Common::none) property.field->set(room, writer_.field_value(property, p.value));
  }
  const std::optional<scene::Problem> problem = type.maker.check(room);
  if (!problem) return true;
  fail("E0407", place_of(described.properties, type, problem->field, described.place), problem->message, {},
       problem->advice);
  return false;
}

std::optional<scene::ShapeRef> Evaluator::shape(const ThingView& described) {
  if (described.thing && described.thing->shape) return described.thing->shape;
  Room room(described.type->maker);
  if (!make(described, room.get())) return std::nullopt;
  const scene::ShapeRef made = described.type->maker.add(scene_.shapes, room.get());
  if (described.thing) described.thing->shape = made;
  return made;
}

// Of a thing that is about to be copied: its copies will share it.
std::optional<scene::ShapeRef> Evaluator::shared_shape(const Thing& thing) {
  if (thing.shape || unsure_ > 0 || is_poisoned(thing.properties)) return thing.shape;
  Room room(thing.type->maker);
  for (const PropertyValue& p : thing.properties) {
    const Property& property = thing.type->properties[p.id];
    if (property.common == Common::none) property.field->set(room.get(), writer_.field_value(property, p.value));
  }
  if (thing.type->maker.check(room.get())) return std::nullopt; // said when it is placed, if it is
  thing.shape = thing.type->maker.add(scene_.shapes, room.get());
  has_leftovers_ = true;
  return thing.shape;
}

std::optional<ObjectAttributes> Evaluator::attributes_of(const ThingView& described, const Content* content) {
  ObjectAttributes attributes_of;
  const auto apply = [&](std::span<const PropertyValue> properties) {
    for (const PropertyValue& p : properties) {
      if ((p.id & parameter_bit) != 0) continue;
      const Property& property = described.type->properties[p.id];
      if (property.common != Common::none) writer_.apply(attributes_of, property, p.value);
    }
  };
  if (content) apply(content->defaults);
  apply(described.properties);
  return attributes_of;
}

void Evaluator::put_shape(const ThingView& described, Target& target) {
  if (unsure_ > 0 || is_poisoned(described.properties)) return;
  ++target.things;
  const NodeType& type = *described.type;
  Ref<Content> inside;
  if (type.is_composite()) {
    if (described.thing) inside = content(*described.thing);
    if (!inside || inside->is_nothing) {
      const bool is_open_end = type.category == Category::combination &&
                               type.operation != scene::Combination::Operation::unite && (!inside || !inside->is_cut);
      if (is_open_end) {
        fail("E0407", described.place, fmt::format("the block of this {} holds no solid", type.name));
        return;
      }
    }
    if (inside && is_poisoned(inside->defaults)) return;
  }
  const auto attributes = attributes_of(described, inside.get());
  const bool is_missing = !attributes->is_visible || (inside && inside->is_nothing);
  if (target.type && target.type->category == Category::combination && is_missing) {
    target.is_one_missing = true;
    if (target.things == 1) target.is_first_missing = true;
  }
  if (!attributes->is_visible) return;
  const auto turn = writer_.transform(*attributes, described.chain);
  if (!turn) return fail_flattened(described.place);
  if (inside && !inside->lights.empty()) put_lights_of(*inside, *attributes, described, target);
  if (inside && inside->is_nothing) return;
  const std::optional<scene::ShapeRef> made = inside ? content_shape(*inside, type, described.place) : shape(described);
  if (!made) return;
  if (report_.wants_remarks()) remark_medium(described, inside.get(), *made);
  if (target.type && target.type->category == Category::combination && !is_operand(described, *made)) return;
  count_objects(1, described.place);
  target.depth = std::max<std::uint16_t>(target.depth, inside ? inside->depth : 0);
  scene::Object& object = target.objects->emplace_back();
  object.at = attributes->at;
  object.shape = *made;
  object.transform = *turn;
  object.material = attributes->material;
  object.name = attributes->name;
  if (object.name == scene::no_name && described.thing) object.name = default_name(described.thing->default_name);
  object.origin = writer_.origin(described.place);
  object.casts_shadow = attributes->casts_shadow;
}

void Evaluator::fail_flattened(Span place) {
  fail("E0406", place,
       "this thing is flattened, or stretched without end: the determinant of its transform is 0 or infinite");
}

std::optional<scene::ShapeRef> Evaluator::content_shape(Content& content, const NodeType& type, Span place) {
  if (content.shape) return content.shape;
  if (type.category == Category::group) {
    content.shape = builder_.group(std::move(content.members));
  } else {
    content.shape = builder_.combination(type.operation, std::move(content.members));
    remember_places(place);
  }
  content.members = {};
  return content.shape;
}

// Every combination that was made since is said to be written here.
void Evaluator::remember_places(Span place) {
  combination_places_.resize(scene_.shapes.all<scene::Combination>().size(), place);
}

// A solid whose material lets light through and does not say how it bends it.
void Evaluator::remark_medium(const ThingView& described, const Content* content, scene::ShapeRef made) {
  const Value* material = nullptr;
  const auto look = [&](std::span<const PropertyValue> properties) {
    for (const PropertyValue& p : properties) {
      if ((p.id & parameter_bit) == 0 && described.type->properties[p.id].common == Common::material)
        material = &p.value;
    }
  };
  if (content) look(content->defaults);
  look(described.properties);
  if (!material || !material->is(ValueKind::thing) || material->thing().type->category != Category::material) return;
  const Thing& thing = material->thing();
  const PropertyValue* refract = thing.find(*thing.type->find(std::string_view("refract")));
  const PropertyValue* ior = thing.find(*thing.type->find(std::string_view("ior")));
  if (!refract || ior) return;
  const Value& share = refract->value;
  const bool bends_nothing = is_pattern(share) || (share.is_number() && share.number() > 0);
  if (!bends_nothing || !builder_.open_part(made).empty()) return;
  if (Diagnostic* d = report_.remark(lint_rule::no_ior.code, refract->span)) {
    d->message = "`refract` without `ior`: light goes straight through this solid";
    d->label = "`ior` is 1 unless it is written";
    d->notes.push_back({std::nullopt, "write `ior: 1.5` for glass, `ior: 1.33` for water, or `ior: 1` if it is meant"});
  }
}

bool Evaluator::is_operand(const ThingView& described, scene::ShapeRef made) {
  const std::string_view open = builder_.open_part(made);
  if (open.empty()) return true;
  const bool is_itself = open == described.type->name;
  fail("E0401", described.place,
       is_itself ? fmt::format("this {} is open: it has no inside, so it cannot be combined", open)
                 : fmt::format("there is a {} in this {}, which is open: it has no inside, so it cannot be combined",
                               open, described.type->name),
       {},
       "solids are: spheres, planes, boxes, closed or infinite cylinders, closed cones, and groups and combinations of "
       "these");
  return false;
}

void Evaluator::put_lights_of(const Content& inside, const ObjectAttributes& attributes, const ThingView& described,
                              Target& target) {
  if (target.type && target.type->category == Category::combination) {
    fail("E0402", described.place,
         fmt::format("there is a light in this {}, and light is no solid", described.type->name));
    return;
  }
  const bool is_placed = attributes.at != Vec3{} || attributes.rotate != Vec3{} || attributes.scale != Vec3{1, 1, 1} ||
                         (described.chain && !described.chain->steps.empty());
  count_objects(inside.lights.size(), described.place);
  for (const scene::Light& light : inside.lights) {
    scene::Light& copy = target.lights->emplace_back(light);
    if (!is_placed) continue;
    copy.enclosing.push_back({attributes.scale, attributes.rotate, attributes.at,
                              described.chain ? described.chain->steps : std::vector<scene::Step>{}});
  }
}

void Evaluator::put_light(const ThingView& described, Target& target) {
  if (unsure_ > 0 || is_poisoned(described.properties)) return;
  ++target.things;
  const NodeType& type = *described.type;
  if (target.type && target.type->category == Category::combination) {
    fail("E0402", described.place, fmt::format("a {} is no solid: it cannot be combined", type.name));
    return;
  }
  Room room(type.maker);
  if (!make(described, room.get())) return;
  const auto attributes = attributes_of(described, nullptr);
  if (described.chain && scene::flattens({{1, 1, 1}, {}, {}, described.chain->steps}))
    return fail_flattened(described.place);
  count_objects(1, described.place);
  scene::Light& light = target.lights->emplace_back();
  light.source = type.maker.light(room.get());
  if (described.chain) light.chain = described.chain->steps;
  light.name = attributes->name;
  if (light.name == scene::no_name && described.thing) light.name = default_name(described.thing->default_name);
  light.origin = writer_.origin(described.place);
}

void Evaluator::put_camera(const ThingView& described, Target& target) {
  if (target.kind != Target::Kind::scene) {
    fail("E0403", described.place, "a camera stands at the top level, not inside a thing");
    return;
  }
  if (unsure_ > 0) return;
  if (camera_place_) {
    if (Diagnostic* d = error("E0404", described.place)) {
      d->message = "there is a camera already, and a scene has one";
      d->notes.push_back({*camera_place_, "the first one is here"});
    }
    return;
  }
  camera_place_ = described.place;
  if (is_poisoned(described.properties)) return;
  Room room(described.type->maker);
  if (!make(described, room.get())) return;
  scene_.camera = *static_cast<const scene::Camera*>(room.get());
  scene_.camera_origin = writer_.origin(described.place);
}

} // namespace rt::lang
