#include "lang/values/property_check.hpp"

#include "lang/text/characters.hpp"
#include "lang/values/builtin.hpp"
#include "lang/values/css_colors.hpp"
#include "lang/values/properties.hpp"
#include "lang/values/thing.hpp"
#include "lang/values/value_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace rt::lang {
namespace {

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

/// Why a value is no vector of three numbers.
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
      if (pattern.type->properties[i].type == PropertyType::stops) {
        if (auto mistake = check_stops_of(pattern, written)) return mistake;
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
    const auto value = written ? written->value : default_value(*pattern.type, pattern.type->properties[id]);
    const std::string what = fmt::format("the `{}` of this {}", pattern.type->properties[id].name, pattern.type->name);
    return value ? check_shown(*value, what, written != nullptr) : std::nullopt;
  }

  std::optional<Diagnostic> check_stops_of(const Thing& pattern, const PropertyValue* written) {
    const std::string what = fmt::format("a stop of this {}", pattern.type->name);
    if (written && written->value.is_poison()) return std::nullopt;
    if (!written) {
      auto mistake = check_shown(Value(0.0), what, true);
      return mistake ? mistake : check_shown(Value(1.0), what, true);
    }
    for (std::size_t i = 0; i < sequence_size(written->value); ++i)
      if (auto mistake = check_shown(as_stop(sequence_at(written->value, i))->shown, what, true)) return mistake;
    return std::nullopt;
  }

  std::optional<Diagnostic> check_shown(const Value& value, const std::string& what, bool is_written) {
    if (value.is_poison()) return std::nullopt;
    if (is_pattern(value)) return run(value.thing());
    if (is_function(value)) return check_gives_number(property_, value);
    if (is_written && !value.is_number())
      return errors::wrong_property_value(
          {}, fmt::format("`{}` takes a number or a pattern of numbers, not one of colours", property_.name),
          "this contains a colour");
    const std::optional<Color> shown = as_color(value);
    auto mistake = shown ? mistake_of(property_, check(property_.constraint, shown->r)) : std::nullopt;
    if (mistake) mistake->label = fmt::format("{} is {}", what, format_number(shown->r));
    return mistake;
  }

  const Property& property_;
  std::set<const Thing*> seen_;
};

/// Of a property that takes patterns. What a pattern holds was checked as colours when it was made.
std::optional<Diagnostic> check_varying(const Property& property, const Value& value) {
  if (property.type == PropertyType::color) return std::nullopt;
  return is_pattern(value) ? PatternCheck(property).run(value.thing()) : check_gives_number(property, value);
}

/// A pattern where there can be none.
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

bool is_shown_by_stops(const Value& value) {
  return as_color(value) || is_pattern(value) || is_function(value);
}

std::optional<Diagnostic> check_stops(const Property& property, const Value& value) {
  if (!is_sequence(value) || value.is(ValueKind::range)) return wrong_type(property, value);
  scene::Stops stops;
  for (std::size_t i = 0; i < sequence_size(value); ++i) {
    const Value element = sequence_at(value, i);
    const std::optional<StopParts> stop = as_stop(element);
    if (element.is_poison() || (stop && stop->shown.is_poison())) return std::nullopt;
    if (!stop || !is_shown_by_stops(stop->shown)) {
      Diagnostic mistake = wrong_type(property, value);
      mistake.label =
          stop ? fmt::format("what stop {} shows is {}", i, describe(stop->shown))
               : fmt::format("stop {} is {}, and not a place with what is shown there", i, describe(element));
      if (stop) mistake.label = color_way_out(stop->shown).value_or(mistake.label);
      return mistake;
    }
    stops.push_back({stop->place, as_color(stop->shown).value_or(black)});
  }
  return mistake_of(property, scene::detail::check_stops(stops));
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

std::optional<Diagnostic> check_value(const Property& property, const Value& value) {
  if (value.is_poison()) return std::nullopt;
  if (is_pattern(value) || is_function(value)) {
    if (property.is_textured()) return check_varying(property, value);
    if (property.field && !property.field->constant_because.empty()) return must_be_constant(property, value);
  }
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
  case PropertyType::stops:
    return check_stops(property, value);
  case PropertyType::material:
    return check_material(property, value);
  case PropertyType::text:
    return require(value.is(ValueKind::string), property, value);
  }
  return std::nullopt;
}

} // namespace rt::lang
