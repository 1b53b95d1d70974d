#include "lang/values/properties.hpp"

#include "lang/text/characters.hpp"
#include "lang/values/builtin.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/thing.hpp"
#include "lang/values/value_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rt::lang {
namespace {

bool has_category(const Value& value, Category category) {
  return value.is(ValueKind::thing) && value.thing().type->category == category;
}

Diagnostic wrong_type(const Property& property, const Value& value) {
  std::string wanted(describe(property));
  if (property.type == PropertyType::choice) {
    wanted.clear();
    for (std::size_t i = 0; i < property.choices.size(); ++i) {
      if (i > 0) wanted += i + 1 == property.choices.size() ? " or " : ", ";
      wanted += fmt::format("`{}`", property.choices[i]);
    }
  }
  return errors::wrong_property_value({}, fmt::format("`{}` takes {}, not {}", property.name, wanted, describe(value)),
                                      "this is " + describe(value));
}

std::optional<Diagnostic> mistake_of(const Property& property, const std::optional<scene::Violation>& violation) {
  using Kind = scene::Violation::Kind;
  if (!violation) return std::nullopt;
  const auto error = violation->kind == Kind::not_finite ? errors::not_finite
                     : violation->kind == Kind::flattens ? errors::flattened
                                                         : errors::value_out_of_bounds;
  return error({}, fmt::format("`{}` {}", property.name, violation->rule), violation->found, {});
}

/// Why a value is not a vector of three numbers.
Diagnostic no_vector(const Property& property, const Value& value) {
  Diagnostic mistake = wrong_type(property, value);
  if (value.is(ValueKind::vector)) mistake.label = "this has two numbers";
  if (!value.is(ValueKind::list)) return mistake;
  const std::vector<Value>& items = value.items();
  if (items.size() != 3) mistake.label = fmt::format("this has {} elements", items.size());
  for (std::size_t i = 0; i < items.size() && items.size() == 3; ++i) {
    if (!items[i].is_number()) mistake.label = fmt::format("element {} is {}", i, describe(items[i]));
  }
  return mistake;
}

std::optional<Diagnostic> check_vector(const Property& property, const Value& value) {
  if (!value.is_vector3()) return no_vector(property, value);
  return mistake_of(property, check(property.constraint, value.vector()));
}

std::optional<Diagnostic> check_size(const Property& property, const Value& value) {
  const bool is_number = value.is_number();
  if (!is_number && !value.is_vector3()) return no_vector(property, value);
  const Vec3 v = is_number ? Vec3{value.number(), value.number(), value.number()} : value.vector();
  return mistake_of(property, check_size(property.constraint, v));
}

// How to write the colour that a vector or a string is meant to be.
std::optional<std::string> color_way_out(const Value& value, bool takes_material = false) {
  if (value.is_vector3()) {
    const Vec3& v = value.vector();
    const bool is_bytes = std::max({v.x, v.y, v.z}) > 1;
    if (!is_bytes)
      return fmt::format("write `rgb({}, {}, {})`", format_number(v.x), format_number(v.y), format_number(v.z));
    const auto byte = [](double x) { return std::lround(std::clamp(x, 0.0, 255.0)); };
    return fmt::format("write `#{:02x}{:02x}{:02x}`", byte(v.x), byte(v.y), byte(v.z));
  }
  if (!value.is(ValueKind::string)) return std::nullopt;
  const std::string& text = value.text();
  const bool is_name =
      find_css_color(text) || (takes_material && !text.empty() && std::ranges::all_of(text, is_name_part));
  if (is_name || text.starts_with('#')) return fmt::format("write `{}`, without quotes", text);
  return std::nullopt;
}

std::optional<Diagnostic> check_color(const Property& property, const Value& value) {
  const auto color = as_color(value);
  if (!color) {
    Diagnostic mistake = wrong_type(property, value);
    mistake.label = color_way_out(value).value_or(mistake.label);
    if (has_category(value, Category::material))
      mistake.notes.push_back({std::nullopt, "a material has a colour of its own: `m.color`"});
    return mistake;
  }
  return mistake_of(property, check(property.constraint, *color));
}

/// What a function that was compiled gives, where a number is asked for.
std::optional<Diagnostic> check_gives_number(const Property& property, const Value& function) {
  if (function.closure().compiled->results.size() == 1) return std::nullopt;
  return errors::wrong_property_value(
      {}, fmt::format("`{}` takes a number or a pattern of numbers, not one of colours", property.name),
      "this function gives a colour");
}

/// Looks through a pattern, all the way down, for what a property that is a number would not take by itself.
class PatternCheck {
public:
  explicit PatternCheck(const Property& property) : property_(property) {}

  std::optional<Diagnostic> run(const Thing& pattern) {
    if (!seen_.insert(&pattern).second) return std::nullopt;
    for (std::size_t i = 0; i < pattern.type->properties.size(); ++i) {
      const auto id = static_cast<std::uint16_t>(i);
      const PropertyValue* written = pattern.find(id);
      if (written && is_function(written->value)) {
        if (auto mistake = check_gives_number(property_, written->value)) return mistake;
        continue;
      }
      if (!pattern.type->properties[i].is_textured()) continue;
      if (auto mistake = check_part(pattern, id)) return mistake;
    }
    return std::nullopt;
  }

private:
  std::optional<Diagnostic> check_part(const Thing& pattern, std::uint16_t id) {
    const PropertyValue* written = pattern.find(id);
    if (written && is_pattern(written->value)) return run(written->value.thing());
    if (written && written->value.is_poison()) return std::nullopt;
    if (written && !written->value.is_number())
      return errors::wrong_property_value(
          {}, fmt::format("`{}` takes a number or a pattern of numbers, not one of colours", property_.name),
          "this holds a colour");
    const auto value = written ? written->value : default_value(*pattern.type, pattern.type->properties[id]);
    const std::optional<Color> shown = value ? as_color(*value) : std::nullopt;
    auto mistake = shown ? mistake_of(property_, check(property_.constraint, shown->r)) : std::nullopt;
    if (mistake)
      mistake->label = fmt::format("the `{}` of this {} is {}", pattern.type->properties[id].name, pattern.type->name,
                                   format_number(shown->r));
    return mistake;
  }

  const Property& property_;
  std::set<const Thing*> seen_;
};

/// A pattern where none is allowed.
Diagnostic must_be_constant(const Property& property, const Value& value) {
  Diagnostic mistake = wrong_type(property, value);
  mistake.notes.push_back({std::nullopt, fmt::format("{}: write one number", property.field->constant_because)});
  return mistake;
}

std::optional<Diagnostic> check_points(const Property& property, const Value& value) {
  if (!is_sequence(value) || value.is(ValueKind::range)) return wrong_type(property, value);
  const std::size_t size = sequence_size(value);
  for (std::size_t i = 0; i < size; ++i) {
    const Value point = sequence_at(value, i);
    if (point.is_poison()) return std::nullopt;
    if (!point.is_vector3()) {
      return errors::wrong_property_value(
          {}, fmt::format("`{}` takes a list of points, each of three numbers", property.name),
          fmt::format("element {} is {}", i, describe(point)));
    }
    if (const auto violation = check(property.constraint, point.vector())) return mistake_of(property, violation);
  }
  return mistake_of(property, check_count(property.constraint, size));
}

std::optional<Diagnostic> check_choice(const Property& property, const Value& value) {
  const std::optional<std::string_view> written = as_choice(value);
  if (written && std::ranges::find(property.choices, *written) != property.choices.end()) return std::nullopt;
  Diagnostic mistake = wrong_type(property, value);
  if (!value.is(ValueKind::choice)) return mistake;
  mistake.message =
      mistake.message.substr(0, mistake.message.rfind(", not")) + fmt::format(", not `{}`", value.choice());
  mistake.label.clear();
  return mistake;
}

std::optional<Diagnostic> check_resolution(const Property& property, const Value& value) {
  const bool is_pair = value.is(ValueKind::vector) && value.vector_size() == 2;
  if (!is_pair) return wrong_type(property, value);
  const Vec3 size = value.vector();
  return mistake_of(property, check(property.constraint, Vec3{size.x, size.y, size.y}));
}

std::optional<Diagnostic> check_material(const Property& property, const Value& value) {
  if (is_material_like(value)) return std::nullopt;
  Diagnostic mistake = wrong_type(property, value);
  mistake.label = color_way_out(value, true).value_or(mistake.label);
  return mistake;
}

std::optional<Diagnostic> check_parts(const Property& property, const Value& value) {
  const bool is_record = value.is(ValueKind::record);
  if (is_record && std::ranges::any_of(value.record().entries, [](const auto& e) { return e.value.is_poison(); }))
    return std::nullopt;
  const std::optional<scene::FieldValue> parts = as_parts(property, value);
  if (!parts) {
    Diagnostic mistake = wrong_type(property, value);
    if (is_record) mistake.label = "this record has other fields, or other values in them";
    if (has_category(value, Category::material)) mistake.label = "this material is no metal";
    return mistake;
  }
  if (const scene::Metal* metal = std::get_if<scene::Metal>(&*parts))
    return mistake_of(property, scene::detail::check_metal(*metal));
  return mistake_of(property, scene::detail::check_absorb(std::get<scene::Absorb>(*parts)));
}

std::optional<Diagnostic> require(bool is_fine, const Property& property, const Value& value) {
  return is_fine ? std::nullopt : std::optional(wrong_type(property, value));
}

} // namespace

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
    return "two whole numbers, [width, height]";
  case PropertyType::metal:
    return "a metal such as gold, or { n: …, k: … }";
  case PropertyType::absorb:
    return "{ color: …, distance: … }";
  case PropertyType::function:
    return "a function of a point";
  case PropertyType::material:
    return "a material, a colour or a pattern";
  case PropertyType::text:
    return "a string";
  }
  return "";
}

std::optional<Diagnostic> check_value(const Property& property, const Value& value) {
  if (value.is_poison()) return std::nullopt;
  // The contents of a pattern were checked as colours when it was made.
  if (is_pattern(value) && property.is_textured() && property.type == PropertyType::color) return std::nullopt;
  if (is_pattern(value) && property.is_textured()) return PatternCheck(property).run(value.thing());
  if (is_function(value) && property.is_textured())
    return property.type == PropertyType::color ? std::nullopt : check_gives_number(property, value);
  if ((is_pattern(value) || is_function(value)) && property.field && !property.field->constant_because.empty())
    return must_be_constant(property, value);
  switch (property.type) {
  case PropertyType::number:
    if (!value.is_number()) return wrong_type(property, value);
    return mistake_of(property, check(property.constraint, value.number()));
  case PropertyType::boolean:
    return require(value.is(ValueKind::boolean), property, value);
  case PropertyType::vector:
    return check_vector(property, value);
  case PropertyType::size:
    return check_size(property, value);
  case PropertyType::color:
    return check_color(property, value);
  case PropertyType::points:
    return check_points(property, value);
  case PropertyType::choice:
    return check_choice(property, value);
  case PropertyType::fade:
    return require(value.is(ValueKind::fade) || value.is(ValueKind::none), property, value);
  case PropertyType::resolution:
    return check_resolution(property, value);
  case PropertyType::metal:
  case PropertyType::absorb:
    return check_parts(property, value);
  case PropertyType::function:
    return require(is_function(value), property, value);
  case PropertyType::material:
    return check_material(property, value);
  case PropertyType::text:
    return require(value.is(ValueKind::string), property, value);
  }
  return std::nullopt;
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

std::optional<std::string_view> as_choice(const Value& value) {
  if (value.is(ValueKind::choice)) return value.choice();
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

bool is_function(const Value& value) {
  return value.is(ValueKind::closure);
}

bool takes_function(const Property& property) {
  return property.is_textured() || property.type == PropertyType::material || property.type == PropertyType::function;
}

bool is_pattern(const Value& value) {
  return has_category(value, Category::pattern);
}

bool is_material_like(const Value& value) {
  return has_category(value, Category::material) || is_pattern(value) || is_function(value) ||
         value.is(ValueKind::record) || (!value.is_number() && as_color(value).has_value());
}

} // namespace rt::lang
