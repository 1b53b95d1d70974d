#pragma once

#include "lang/diagnostics/diagnostic.hpp"
#include "lang/values/node_types.hpp"
#include "lang/values/value.hpp"

#include <optional>
#include <string>

namespace rt::lang {

/// What is wrong with a value, before it is known where it stands.
struct Mistake {
  std::string code;
  std::string message;
  std::string label;
  std::vector<std::string> advice = {};
};

/// "a number", "a vector of three numbers": what a property takes.
std::string_view describe(const Property& property);

/// Whether the property takes the value: its type, then its constraint. Poison passes.
std::optional<Mistake> check_value(const Property& property, const Value& value);

/// What a property is where it is not written; nothing where it has no value then (a plane's `y`).
std::optional<Value> default_value(const NodeType& type, const Property& property);

/// A colour, a number as grey, or what has a colour's name; else nothing.
std::optional<Color> as_color(const Value& value);

/// Whether the value is a pattern.
bool is_pattern(const Value& value);
/// Whether the value may stand where a material is asked for: a material, a colour, a pattern, a record.
bool is_material_like(const Value& value);

} // namespace rt::lang
