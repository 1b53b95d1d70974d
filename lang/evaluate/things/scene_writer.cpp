#include "lang/evaluate/things/scene_writer.hpp"

#include "lang/check/lint/rules.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/values/value_errors.hpp"
#include "renderer/scene/validation/media_conflicts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {
namespace {

// Why it is not a valid thing of its kind although each field's value is valid.
std::optional<scene::Problem> problem_of(const Prototype& made) {
  return std::visit(
      [](const auto& of_kind) -> std::optional<scene::Problem> {
        if constexpr (requires { scene::check(of_kind); })
          return scene::check(of_kind);
        else
          return std::nullopt;
      },
      made);
}

scene::ShapeRef add_shape(scene::Shapes& shapes, Prototype&& made) {
  return std::visit(
      [&]<class T>(T& of_kind) -> scene::ShapeRef {
        if constexpr (scene::kind_of<T> < scene::ShapeKinds::size)
          return shapes.add(std::move(of_kind));
        else
          throw std::bad_variant_access();
      },
      made);
}

Span place_of(std::span<const PropertyValue> properties, const NodeType& type, std::string_view property,
              Span otherwise) {
  for (const PropertyValue& p : properties) {
    if ((p.id & parameter_bit) == 0 && type.properties[p.id].name == property) return p.span;
  }
  return otherwise;
}

bool is_poisoned(std::span<const PropertyValue> properties) {
  return std::ranges::any_of(properties, [](const PropertyValue& p) { return p.value.is_poison(); });
}

} // namespace

bool SceneWriter::takes(const ThingView& described, const Target& target) const {
  const bool is_open = target.kind == Target::Kind::scene || target.kind == Target::Kind::content;
  return is_open && !errors_.is_unsure() && !is_poisoned(described.properties);
}

void SceneWriter::put(const ThingView& described, Target& target) {
  const NodeType& type = *described.type;
  if (target.kind == Target::Kind::discarded) return;
  if (target.kind == Target::Kind::bare) {
    if (!target.properties) return; // the block of something in error
    const NodeType& owner = *target.properties->type;
    const std::string_view whose = target.properties->def ? name(target.properties->def->name) : owner.name;
    const bool is_property = owner.find(program_.symbols.find(type.name)).has_value();
    fail(errors::takes_no_things(described.place, fmt::format("things cannot be put into `{}`", whose),
                                 is_property ? fmt::format("write `{}: {{ … }}`", type.name) : "",
                                 "a `group` and the combinations take things; other blocks hold properties only"));
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
  fail(errors::not_placeable(described.place, fmt::format("a {} is not placed: it belongs to a shape", type.name), {},
                             type.category == Category::material
                                 ? "keep it with `name = …`, or write it after `material:`"
                                 : "write it after `material:`, or as a material's `color`"));
}

void SceneWriter::set_fields(Prototype& made, const NodeType& type, std::span<const PropertyValue> properties) {
  void* const fields = owner(made);
  for (const PropertyValue& p : properties) {
    const Property& property = type.properties[p.id];
    if (property.common == Common::none) property.field->set(fields, description_.field_value(property, p.value));
  }
}

std::optional<Prototype> SceneWriter::make(const ThingView& described) {
  std::optional<Prototype> made(described.type->prototype);
  set_fields(*made, *described.type, described.properties);
  const std::optional<scene::Problem> problem = problem_of(*made);
  if (!problem) return made;
  fail(errors::properties_disagree(place_of(described.properties, *described.type, problem->field, described.place),
                                   problem->message, {}, problem->advice));
  return std::nullopt;
}

std::optional<scene::ShapeRef> SceneWriter::shape(const ThingView& described) {
  if (described.thing && described.thing->shape) return described.thing->shape;
  std::optional<Prototype> made = make(described);
  if (!made) return std::nullopt;
  const scene::ShapeRef shape = add_shape(scene_.shapes, std::move(*made));
  if (described.thing) described.thing->shape = shape;
  return shape;
}

// Of a thing that is about to be copied: its copies will share it.
std::optional<scene::ShapeRef> SceneWriter::shared_shape(const Thing& thing) {
  if (thing.shape || errors_.is_unsure() || is_poisoned(thing.properties)) return thing.shape;
  Prototype made = thing.type->prototype;
  set_fields(made, *thing.type, thing.properties);
  if (problem_of(made)) return std::nullopt; // reported when it is placed, if it is
  thing.shape = add_shape(scene_.shapes, std::move(made));
  evaluation_.may_have_unused = true;
  return thing.shape;
}

ObjectAttributes SceneWriter::attributes_of(const ThingView& described) {
  ObjectAttributes attributes;
  const auto apply = [&](std::span<const PropertyValue> properties) {
    for (const PropertyValue& p : properties) {
      if ((p.id & parameter_bit) != 0) continue;
      const Property& property = described.type->properties[p.id];
      if (property.common != Common::none) description_.apply(attributes, property, p.value);
    }
  };
  const std::size_t known_patterns = scene_.patterns.size();
  if (described.inside) apply(described.inside->defaults);
  apply(described.properties);
  for (std::size_t i = known_patterns; i < scene_.patterns.size(); ++i)
    if (flattens(scene_.patterns[i].placement))
      fail(errors::flattened(described.place, "the transform of a pattern on this thing is singular or infinite"));
  return attributes;
}

// A difference or an intersection of no solids is meaningless.
bool SceneWriter::is_something(const ThingView& described) {
  const NodeType& type = *described.type;
  const Content* inside = described.inside;
  const bool is_open_end = type.category == Category::combination && (!inside || inside->is_nothing) &&
                           type.operation != scene::Combination::Operation::unite && (!inside || !inside->is_cut);
  if (is_open_end)
    fail(
        errors::properties_disagree(described.place, fmt::format("the block of this {} contains no solid", type.name)));
  return !is_open_end && !(inside && is_poisoned(inside->defaults));
}

void SceneWriter::put_shape(const ThingView& described, Target& target) {
  if (!takes(described, target)) return;
  ++target.things;
  if (!is_something(described)) return;
  const Content* inside = described.inside;
  const ObjectAttributes attributes = attributes_of(described);
  const bool is_missing = !attributes.is_visible || (inside && inside->is_nothing);
  if (target.is_combination() && is_missing) {
    target.is_one_missing = true;
    if (target.things == 1) target.is_first_missing = true;
  }
  if (!attributes.is_visible) return;
  const auto transform = description_.transform(attributes, described.chain);
  if (!transform) return fail_flattened(described.place);
  if (inside && !inside->lights.empty()) put_lights_of(*inside, attributes, described, target);
  if (!inside || !inside->is_nothing) add_object(described, attributes, *transform, target);
}

void SceneWriter::add_object(const ThingView& described, const ObjectAttributes& attributes,
                             scene::TransformId transform, Target& target) {
  Content* inside = described.inside;
  const auto made = inside ? content_shape(*inside, *described.type, described.place) : shape(described);
  if (!made) return;
  if (errors_.report().wants_remarks()) remark_medium(described, *made);
  if (target.is_combination() && !is_operand(described, *made)) return;
  limits_.count_objects(1, described.place);
  target.depth = std::max<std::uint16_t>(target.depth, inside ? inside->depth : 0);
  scene::Object& object = target.objects->emplace_back();
  object.at = attributes.at;
  object.shape = *made;
  object.transform = transform;
  object.material = attributes.material;
  object.name = attributes.name;
  if (object.name == scene::no_name && described.thing) object.name = default_name(described.thing->default_name);
  object.origin = description_.origin(described.place);
  object.casts_shadow = attributes.casts_shadow;
}

void SceneWriter::fail_flattened(Span place) {
  fail(errors::flattened(place,
                         "the transform of this thing is singular or infinite: its determinant is 0 or infinite"));
}

std::optional<scene::ShapeRef> SceneWriter::content_shape(Content& content, const NodeType& type, Span place) {
  if (content.shape) return content.shape;
  if (type.category == Category::group) {
    content.shape = builder_.group(std::move(content.members));
  } else {
    content.shape = builder_.combination(type.operation, std::move(content.members));
    // Every combination made since is attributed to this place.
    combination_places_.resize(scene_.shapes.all<scene::Combination>().size(), place);
  }
  content.members = {};
  return content.shape;
}

// A solid whose material is transparent and specifies no index of refraction.
void SceneWriter::remark_medium(const ThingView& described, scene::ShapeRef made) {
  const Value* material = nullptr;
  const auto look = [&](std::span<const PropertyValue> properties) {
    for (const PropertyValue& p : properties) {
      if ((p.id & parameter_bit) == 0 && described.type->properties[p.id].common == Common::material)
        material = &p.value;
    }
  };
  if (described.inside) look(described.inside->defaults);
  look(described.properties);
  if (!material || !material->is(ValueKind::thing) || material->thing().type->category != Category::material) return;
  const Thing& thing = material->thing();
  const PropertyValue* refract = thing.find(*thing.type->find(std::string_view("refract")));
  const PropertyValue* ior = thing.find(*thing.type->find(std::string_view("ior")));
  const PropertyValue* thin = thing.find(*thing.type->find(std::string_view("thin")));
  if (!refract || ior || (thin && thin->value.is(ValueKind::boolean) && thin->value.truth())) return;
  const Value& share = refract->value;
  const bool bends_nothing = is_pattern(share) || is_function(share) || (share.is_number() && share.number() > 0);
  if (!bends_nothing || !builder_.open_part(made).empty()) return;
  if (Diagnostic* d = errors_.report().remark(lint_rule::no_ior.code, refract->span)) {
    d->message = "`refract` without `ior`: light goes straight through this solid";
    d->label = "`ior` defaults to 1";
    d->notes.push_back({std::nullopt, "write `ior: 1.5` for glass, `ior: 1.33` for water, or `ior: 1` if it is meant"});
  }
}

bool SceneWriter::is_operand(const ThingView& described, scene::ShapeRef made) {
  const std::string_view open = builder_.open_part(made);
  if (open.empty()) return true;
  const bool is_itself = open == described.type->name;
  fail(errors::open_in_combination(
      described.place,
      is_itself ? fmt::format("this {} is open: it has no inside, so it cannot be combined", open)
                : fmt::format("there is a {} in this {}, which is open: it has no inside, so it cannot be combined",
                              open, described.type->name),
      {},
      "solids are: spheres, planes, boxes, closed or infinite cylinders, closed cones, and groups and combinations of "
      "these"));
  return false;
}

void SceneWriter::put_lights_of(const Content& inside, const ObjectAttributes& attributes, const ThingView& described,
                                Target& target) {
  if (target.is_combination()) {
    fail(errors::light_in_combination(
        described.place, fmt::format("there is a light in this {}, and a light is not a solid", described.type->name)));
    return;
  }
  const bool is_placed = attributes.at != Vec3{} || attributes.rotate != Vec3{} || attributes.scale != Vec3{1, 1, 1} ||
                         (described.chain && !described.chain->steps.empty());
  limits_.count_objects(inside.lights.size(), described.place);
  for (const scene::Light& light : inside.lights) {
    note_sky(light, described.place, target);
    scene::Light& copy = target.lights->emplace_back(light);
    if (!is_placed) continue;
    copy.enclosing.push_back({attributes.scale, attributes.rotate, attributes.at,
                              described.chain ? described.chain->steps : std::vector<scene::Step>{}});
  }
}

void SceneWriter::put_light(const ThingView& described, Target& target) {
  if (!takes(described, target)) return;
  ++target.things;
  const NodeType& type = *described.type;
  if (target.is_combination()) {
    fail(errors::light_in_combination(described.place,
                                      fmt::format("a {} is not a solid: it cannot be combined", type.name)));
    return;
  }
  const std::optional<Prototype> made = make(described);
  if (!made) return;
  const auto attributes = attributes_of(described);
  if (described.chain && scene::flattens({{1, 1, 1}, {}, {}, described.chain->steps}))
    return fail_flattened(described.place);
  limits_.count_objects(1, described.place);
  scene::Light& light = target.lights->emplace_back();
  light.source = narrowed<scene::LightSource>(*made);
  if (described.chain) light.chain = described.chain->steps;
  light.name = attributes.name;
  if (light.name == scene::no_name && described.thing) light.name = default_name(described.thing->default_name);
  light.origin = description_.origin(described.place);
  note_sky(light, described.place, target);
}

// A scene has one sky, wherever it is written.
void SceneWriter::note_sky(const scene::Light& light, Span place, const Target& target) {
  if (target.kind != Target::Kind::scene || scene::is_lamp(light) || errors_.is_unsure()) return;
  if (sky_place_)
    fail(errors::second_sky(place, *sky_place_));
  else
    sky_place_ = place;
}

void SceneWriter::put_camera(const ThingView& described, Target& target) {
  if (target.kind != Target::Kind::scene) {
    fail(errors::camera_in_thing(described.place, "a camera must be at the top level, not inside a thing"));
    return;
  }
  if (errors_.is_unsure()) return;
  if (camera_place_) {
    fail(errors::second_camera(described.place, *camera_place_));
    return;
  }
  camera_place_ = described.place;
  if (is_poisoned(described.properties)) return;
  const std::optional<Prototype> made = make(described);
  if (!made) return;
  scene_.camera = std::get<scene::Camera>(*made);
  scene_.camera_origin = description_.origin(described.place);
}

void SceneWriter::check_media(const std::vector<scene::Object>& objects) {
  for (const scene::MediaConflict& conflict : media_conflicts(scene_, objects)) {
    fail(errors::media_disagree(combination_places_[conflict.combination],
                                "the parts of this solid refract differently, and one solid is one medium",
                                fmt::format("`ior` is {} in one part and {} in another",
                                            format_number(conflict.first_ior), format_number(conflict.second_ior)),
                                "give the whole a material, or its parts the same `ior`"));
  }
}

scene::NameId SceneWriter::default_name(Symbol symbol) {
  if (symbol == no_symbol) return scene::no_name;
  const auto i = static_cast<std::size_t>(symbol);
  if (i >= default_names_.size()) default_names_.resize(std::max(i + 1, program_.symbols.size()), scene::no_name);
  if (default_names_[i] == scene::no_name) default_names_[i] = builder_.name(name(symbol));
  return default_names_[i];
}

scene::FieldValue SceneWriter::scene_value(const PropertyValue& property) {
  return description_.field_value(program_.types.scene().properties[property.id], property.value);
}

} // namespace rt::lang
