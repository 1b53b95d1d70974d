#include "lang/values/properties.hpp"

#include "lang/values/builtin.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/thing.hpp"

#include <string>

namespace rt::lang {

std::string_view describe(const Property& property) {
  switch (property.type) {
  case PropertyType::number:
    return property.is_textured() ? "a number, or a pattern of numbers" : "a number";
  case PropertyType::boolean:
    return "true or false";
  case PropertyType::vector:
    return "a vector of three numbers";
  case PropertyType::size:
    return "a number or a vector of three";
  case PropertyType::color:
    return property.is_textured() ? "a colour, a number as grey, or a pattern" : "a colour, or a number as grey";
  case PropertyType::points:
    return "a list of points";
  case PropertyType::choice:
    return "a word";
  case PropertyType::fade:
    return "linear(d), quadratic(d) or inverse_square";
  case PropertyType::resolution:
    return "two integers, [width, height]";
  case PropertyType::metal:
    return "a metal such as gold, or { n: …, k: … }";
  case PropertyType::absorb:
    return "{ color: …, distance: … }";
  case PropertyType::function:
    return "a function of a point";
  case PropertyType::stops:
    return "a list of stops such as [[0, navy], [1, white]]";
  case PropertyType::material:
    return "a material, a colour or a pattern";
  case PropertyType::text:
    return "a string";
  }
  return "";
}

namespace {

Value from_color(const Property& property, const Color& color) {
  return property.type == PropertyType::number ? Value(color.r) : Value(color);
}

Value from_fade(const scene::Fade& fade) {
  return fade.law == scene::Fade::Law::none ? Value() : Value(fade);
}

std::optional<Value> to_value(const Property& property, const scene::FieldValue& value) {
  if (const double* number = std::get_if<double>(&value)) return Value(*number);
  if (const bool* truth = std::get_if<bool>(&value)) return Value::boolean(*truth);
  if (const Vec3* vector = std::get_if<Vec3>(&value)) return Value(*vector);
  if (const Color* color = std::get_if<Color>(&value)) return from_color(property, *color);
  if (const scene::Choice* choice = std::get_if<scene::Choice>(&value))
    return Value::choice(property.choices[static_cast<std::size_t>(choice->index)]);
  if (const scene::Fade* fade = std::get_if<scene::Fade>(&value)) return from_fade(*fade);
  if (const scene::Resolution* size = std::get_if<scene::Resolution>(&value))
    return Value::point((*size)[0], (*size)[1]);
  return std::nullopt; // a list of points or a function, which have no value of their own; a default is never a pattern
}

} // namespace

std::optional<Value> default_value(const NodeType& type, const Property& property) {
  switch (property.common) {
  case Common::at:
  case Common::rotate:
    return Value(Vec3{});
  case Common::scale:
    return Value(Vec3{1, 1, 1});
  case Common::visible:
  case Common::casts_shadow:
    return Value::boolean(true);
  case Common::material:
  case Common::name:
    return std::nullopt;
  case Common::none:
    break;
  }
  const auto read = [&](const void* owner) -> std::optional<Value> {
    const auto value = property.field->get(owner);
    return value ? to_value(property, *value) : std::nullopt;
  };
  if (std::holds_alternative<std::monostate>(type.prototype)) return std::nullopt;
  return std::visit([&](const auto& prototype) { return read(&prototype); }, type.prototype);
}

std::optional<scene::FieldValue> as_parts(const Property& property, const Value& value) {
  if (has_category(value, Category::material) && property.type == PropertyType::metal) {
    const auto id = value.thing().type->find(property.name);
    const PropertyValue* own = id ? value.thing().find(*id) : nullptr;
    return own ? as_parts(property, own->value) : std::nullopt;
  }
  if (!value.is(ValueKind::record) || value.record().entries.size() != property.parts.size()) return std::nullopt;
  const Value* first = value.record().find(property.parts[0]);
  const Value* second = value.record().find(property.parts[1]);
  const std::optional<Color> color = first ? as_color(*first) : std::nullopt;
  if (!color || !second) return std::nullopt;
  if (property.type == PropertyType::absorb)
    return second->is_number() ? std::optional(scene::FieldValue(scene::Absorb{*color, second->number()}))
                               : std::nullopt;
  const std::optional<Color> k = as_color(*second);
  return k ? std::optional(scene::FieldValue(scene::Metal{*color, *k})) : std::nullopt;
}

std::optional<StopParts> as_stop(const Value& value) {
  if (!is_sequence(value) || value.is(ValueKind::range) || sequence_size(value) != 2) return std::nullopt;
  const Value place = sequence_at(value, 0);
  return place.is_number() ? std::optional(StopParts{place.number(), sequence_at(value, 1)}) : std::nullopt;
}

std::optional<std::string_view> as_choice(const Value& value) {
  if (value.is(ValueKind::choice)) return value.choice();
  if (value.is(ValueKind::builtin)) return value.builtin()->name;
  const bool is_bare_noun = value.is(ValueKind::thing) && value.thing().properties.empty() && !value.thing().chain;
  return is_bare_noun ? std::optional(value.thing().type->name) : std::nullopt;
}

std::optional<Color> as_color(const Value& value) {
  if (value.is(ValueKind::color)) return value.color();
  if (value.is_number()) return grey(value.number());
  if (value.is(ValueKind::thing) && value.thing().css_color != Thing::no_color)
    return from_srgb8(value.thing().css_color);
  if (value.is(ValueKind::builtin)) { // `tan`
    if (const auto rgb = find_css_color(value.builtin()->name)) return from_srgb8(*rgb);
  }
  return std::nullopt;
}

bool has_category(const Value& value, Category category) {
  return value.is(ValueKind::thing) && value.thing().type->category == category;
}

bool takes_function(const Property& property) {
  return property.is_textured() || property.type == PropertyType::material || property.type == PropertyType::function ||
         property.type == PropertyType::stops;
}

bool is_material_like(const Value& value) {
  return has_category(value, Category::material) || is_pattern(value) || is_function(value) ||
         value.is(ValueKind::record) || (!value.is_number() && as_color(value).has_value());
}

} // namespace rt::lang
