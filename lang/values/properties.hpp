#pragma once

#include "lang/values/node_types.hpp"
#include "lang/values/value.hpp"

#include <optional>
#include <string_view>

namespace rt::lang {

/// "a number", "a vector of three numbers": what a property takes.
std::string_view describe(const Property& property);

/// What a property is where it is not written; nothing where it has no value then (a plane's `y`).
std::optional<Value> default_value(const NodeType& type, const Property& property);

/// The metal or the absorption that the value describes as a record, or has as a material; else nothing.
std::optional<scene::FieldValue> as_parts(const Property& property, const Value& value);

/// A place, and what a pattern shows there.
struct StopParts {
  double place;
  Value shown;
};
/// Those of a list of two of which the first is a number; else nothing.
std::optional<StopParts> as_stop(const Value& value);

/// The word that stands for one of several choices, be it the noun of a thing (`filter: box`) or the name of a function
/// as well; else nothing.
std::optional<std::string_view> as_choice(const Value& value);

/// A colour, a number as grey, or what has a colour's name; else nothing.
std::optional<Color> as_color(const Value& value);

/// Whether the value is a thing of that sort.
bool has_category(const Value& value, Category category);
/// Whether the value is a function of the scene's, which may stand for the pattern that it is.
inline bool is_function(const Value& value) {
  return value.is(ValueKind::closure);
}
/// Whether such a function may be the property's value.
bool takes_function(const Property& property);
/// Whether the value is a pattern.
inline bool is_pattern(const Value& value) {
  return value.is(ValueKind::thing) && has_category(value, Category::pattern);
}
/// Whether the value may stand where a material is asked for: a material, a colour, a pattern, a function,
/// a record.
bool is_material_like(const Value& value);

} // namespace rt::lang
