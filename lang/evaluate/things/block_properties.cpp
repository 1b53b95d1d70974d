#include "lang/check/errors/dialects.hpp"
#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/things/block_evaluator.hpp"
#include "lang/evaluate/things/thing_evaluator.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {

void BlockEvaluator::property_item(NodeId node, const Context& context, Target& target) {
  const Ast& ast = context.ast();
  const Named property = ast.named(node);
  Value value = expressions_.evaluate(property.value, context);
  PropertyBlock* block = target.properties;
  if (!block) return;
  const Span name_place = ast.named_span(node, program_.symbols);
  std::optional<std::uint16_t> id;
  if (ast[node].extra > 0 && !block->def) id = static_cast<std::uint16_t>(ast[node].extra - 1);
  if (!id && block->def) {
    if (const auto parameter = block->def->find(property.symbol)) id = parameter_id(*parameter);
  }
  if (!id) id = block->type->find(property.symbol);
  if (id) return set_property(*block, *id, std::move(value), ast.span(property.value), name_place);
  block->is_broken = true;
  fail_unknown_property(*block, property.symbol, name_place);
}

void BlockEvaluator::fail_unknown_property(const PropertyBlock& block, Symbol property, Span place) {
  std::vector<std::string_view> names;
  if (block.def)
    for (const FunctionInfo::Parameter& p : block.def->parameters) names.push_back(name(p.name));
  for (const Property& p : block.type->properties) names.push_back(p.name);
  const std::string whose = fmt::format("`{}`", block.def ? name(block.def->name) : block.type->name);
  Diagnostic error = errors::no_property(place, fmt::format("{} has no property `{}`", whose, name(property)), {});
  advise_on_property(error, whose, name(property), *block.type, names);
  fail(std::move(error));
}

// Whether a property was already set, or is set in another form; reports it.
bool BlockEvaluator::is_written(const PropertyBlock& block, std::uint16_t id, std::string_view word, Span name_place) {
  const auto form = [&](std::uint16_t i) { return (i & parameter_bit) != 0 ? 0 : block.type->properties[i].form; };
  for (const PropertyBlock::Written& other : block.written) {
    const bool is_twice = other.id == id;
    const bool clashes = form(id) != 0 && form(other.id) != 0 && form(other.id) != form(id);
    if (!is_twice && !clashes) continue;
    fail(is_twice ? errors::property_set_twice(name_place, word, other.name)
                  : errors::two_forms(name_place, word, other.name, block.type->properties[other.id].name));
    return true;
  }
  return false;
}

void BlockEvaluator::set_property(PropertyBlock& block, std::uint16_t id, Value value, Span place, Span name_place) {
  const bool is_parameter = (id & parameter_bit) != 0;
  const Property* property = is_parameter ? nullptr : &block.type->properties[id];
  const std::string_view word = is_parameter ? name(block.def->parameters[id ^ parameter_bit].name) : property->name;
  if (is_written(block, id, word, name_place)) return;
  if (property) {
    things_.prepare(*property, value, place);
    if (property->form != 0) { // the form that is written drops the inherited other one
      std::erase_if(block.values, [&](const PropertyValue& p) {
        const int form = (p.id & parameter_bit) != 0 ? 0 : block.type->properties[p.id].form;
        return form != 0 && form != property->form;
      });
    }
  }
  block.written.push_back({id, name_place});
  for (PropertyValue& p : block.values) {
    if (p.id != id) continue;
    p.value = std::move(value);
    p.span = place;
    return;
  }
  block.values.push_back({std::move(value), place, id});
}

} // namespace rt::lang
