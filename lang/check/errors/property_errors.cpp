#include "lang/check/errors/property_errors.hpp"

#include "lang/check/errors/dialects.hpp"
#include "lang/check/errors/shared_errors.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace rt::lang::errors {
namespace {

std::vector<std::string_view> properties_of(CheckContext& context, const Owner& owner) {
  std::vector<std::string_view> names;
  if (owner.def && !owner.is_def_body) {
    for (const FunctionInfo::Parameter& p : owner.def->parameters) names.push_back(context.name(p.name));
  }
  for (const Property& p : owner.type->properties) names.push_back(p.name);
  return names;
}

/// The value as a colour: `"red"` without quotes, `[1, 0, 0]` with `rgb`.
std::string as_color(std::string_view value) {
  const std::string_view inner = value.substr(1, std::max<std::size_t>(value.size(), 2) - 2);
  if (value.starts_with('"')) return std::string(inner);
  if (value.starts_with('[')) return fmt::format("rgb({})", inner);
  return std::string(value);
}

/// Where the property belongs, if it is known to belong elsewhere; else empty.
std::string better_place(CheckContext& context, const Unit& unit, const Named& property, const Owner& owner) {
  const std::string_view word = context.name(property.symbol);
  const std::string_view value = context.text(unit.ast.span(property.value));
  const bool is_short = value.size() <= 40 && value.find('\n') == std::string_view::npos;
  const std::string_view shown = is_short ? value : "…";
  const Kind kind = unit.ast.kind(property.value);
  const bool is_thing = kind == Kind::override_ || kind == Kind::call || kind == Kind::lambda;
  if (owner.type == &context.program.types.scene() && is_thing)
    return fmt::format("to keep something for later, write `{} = …`", word);
  if (!owner.type->is_shape()) return {};
  if (word == "color" || word == "colour")
    return fmt::format("a colour is a material: write `material: {}`", as_color(shown));
  if (context.program.types.material().find(property.symbol))
    return fmt::format("it belongs to the material: `material: material {{ {}: {} }}`", word, shown);
  return {};
}

} // namespace

void property_without_thing(CheckContext& context, Span place, Symbol name) {
  const std::string_view word = context.name(name);
  context.report.error("E0213", place,
                       fmt::format("`{}:` sets a property, and there is no thing here that has one", word),
                       fmt::format("to bind a name, write `{} = …`", word));
}

void unknown_property(CheckContext& context, const Unit& unit, NodeId item, const Owner& owner) {
  const Named property = unit.ast.named(item);
  const std::string_view word = context.name(property.symbol);
  const bool is_scene = owner.type == &context.program.types.scene();
  const std::string whose =
      is_scene ? "the scene" : fmt::format("`{}`", owner.def ? context.name(owner.def->name) : owner.type->name);
  Diagnostic d =
      no_property(unit.ast.named_span(item, context.program.symbols),
                  fmt::format("{} has no property `{}`", whose, word), better_place(context, unit, property, owner));
  if (d.label.empty()) advise_on_property(d, whose, word, *owner.type, properties_of(context, owner));
  context.report.add(std::move(d));
}

} // namespace rt::lang::errors
