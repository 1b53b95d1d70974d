#include "lang/check/checker.hpp"
#include "lang/check/dialects.hpp"
#include "lang/text/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {

void Checker::check_property(Unit& unit, NodeId item) {
  check_expression(unit, unit.ast.named(item).value);
  const Owner& owner = scopes_.back().owner;
  if (owner.is_unknown) return;
  if (!owner.type) {
    if (Diagnostic* d = report_.error("E0213", unit.ast.named_span(item, program_.symbols))) {
      const std::string_view word = name(unit.ast.named(item).symbol);
      d->message = fmt::format("`{}:` sets a property, and there is no thing here that has one", word);
      d->label = fmt::format("to bind a name, write `{} = …`", word);
    }
    return;
  }
  check_property_name(unit, item, owner);
}

void Checker::check_property_name(Unit& unit, NodeId item, const Owner& owner) {
  const Symbol symbol = unit.ast.named(item).symbol;
  if (owner.def && !owner.is_def_body && owner.def->find(symbol)) return;
  if (const auto found = owner.type->find(symbol)) {
    if (!owner.def) unit.ast[item].extra = static_cast<std::uint16_t>(*found + 1);
    if (report_.wants_remarks()) check_angle_property(unit, item, owner.type->properties[*found]);
    return;
  }
  report_unknown_property(unit, item, owner);
}

std::string Checker::list_properties(const Owner& owner) const {
  std::vector<std::string_view> names;
  if (owner.def && !owner.is_def_body) {
    for (const FunctionInfo::Parameter& p : owner.def->parameters) names.push_back(name(p.name));
  }
  for (const Property& p : owner.type->properties) names.push_back(p.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

void Checker::report_unknown_property(const Unit& unit, NodeId item, const Owner& owner) {
  const Span span = unit.ast.named_span(item, program_.symbols);
  const Named property = unit.ast.named(item);
  const std::string_view word = name(property.symbol);
  const std::string_view value = program_.sources.text(unit.ast.span(property.value));
  const bool is_scene = owner.type == &program_.types.scene();
  const bool is_def = owner.def != nullptr;
  const std::string whose =
      is_scene ? "the scene" : fmt::format("`{}`", is_def ? name(owner.def->name) : owner.type->name);
  Diagnostic* d = report_.error("E0204", span);
  if (!d) return;
  d->message = fmt::format("{} has no property `{}`", whose, word);
  const Kind kind = unit.ast.kind(property.value);
  const bool is_thing = kind == Kind::override_ || kind == Kind::call || kind == Kind::lambda;
  const bool is_short = value.size() <= 40 && value.find('\n') == std::string_view::npos;
  if (is_scene && is_thing) {
    d->label = fmt::format("to keep something for later, write `{} = …`", word);
    return;
  }
  if ((word == "color" || word == "colour") && owner.type->is_shape()) {
    d->label = is_short ? fmt::format("a colour is a material: write `material: {}`", value)
                        : "a colour is a material: write `material: …`";
    return;
  }
  const bool is_material_property =
      owner.type->is_shape() && program_.types.material().find(property.symbol).has_value();
  if (is_material_property) {
    d->label = is_short ? fmt::format("it belongs to the material: `material: material {{ {}: {} }}`", word, value)
                        : fmt::format("it belongs to the material: `material: material {{ {}: … }}`", word);
    return;
  }
  std::vector<std::string_view> names;
  if (is_def && !owner.is_def_body) {
    for (const FunctionInfo::Parameter& p : owner.def->parameters) names.push_back(name(p.name));
  }
  for (const Property& p : owner.type->properties) names.push_back(p.name);
  const auto guess = nearest(word, names);
  const std::string other = dialect_property(word, owner.type);
  if (!other.empty())
    d->label = other;
  else if (guess)
    d->label = fmt::format("did you mean `{}`?", *guess);
  if (is_scene)
    d->notes.push_back({std::nullopt, fmt::format("the scene takes {}", list_properties(owner))});
  else
    d->notes.push_back({std::nullopt, fmt::format("`{}` takes {}", is_def ? name(owner.def->name) : owner.type->name,
                                                  list_properties(owner))});
}

// Of the properties that stand in the block itself; what `if` and `for` put into it is seen when the program runs.
void Checker::report_duplicates(const Unit& unit, NodeId block, const Owner& owner) {
  if (!owner.type || owner.is_unknown) return;
  std::vector<std::pair<Symbol, NodeId>> seen;
  const Property* form_owner = nullptr;
  NodeId form_item = no_node;
  for (const NodeId item : unit.ast.children(block)) {
    if (unit.ast.kind(item) != Kind::property) continue;
    const Symbol symbol = unit.ast.named(item).symbol;
    const auto first = std::ranges::find(seen, symbol, &std::pair<Symbol, NodeId>::first);
    if (first != seen.end()) {
      if (Diagnostic* d = report_.error("E0205", unit.ast.named_span(item, program_.symbols))) {
        d->message = fmt::format("`{}` is written twice", name(symbol));
        d->notes.push_back({unit.ast.named_span(first->second, program_.symbols), "first here"});
      }
      continue;
    }
    seen.emplace_back(symbol, item);
    const auto found = owner.def ? std::nullopt : owner.type->find(symbol);
    const Property* property = found ? &owner.type->properties[*found] : nullptr;
    if (!property || property->form == 0) continue;
    if (form_owner && form_owner->form != property->form) {
      if (Diagnostic* d = report_.error("E0206", unit.ast.named_span(item, program_.symbols))) {
        d->message = fmt::format("`{}` and `{}` are two ways to say the same", form_owner->name, property->name);
        d->label = "leave one of them out";
        d->notes.push_back({unit.ast.named_span(form_item, program_.symbols), "the other one is here"});
      }
      continue;
    }
    form_owner = property;
    form_item = item;
  }
}

} // namespace rt::lang
