#include "lang/check/properties.hpp"

#include "lang/check/errors/property_errors.hpp"
#include "lang/check/errors/shared_errors.hpp"
#include "lang/values/thing.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rt::lang {
namespace {

/// The first property of each name in a block or record, in order.
class FirstOnes {
public:
  FirstOnes(CheckContext& context, const Ast& ast) : context_(context), ast_(ast) {}

  /// Whether it is the first of its name; reported if it is not.
  bool add(NodeId item) {
    const Symbol symbol = ast_.named(item).symbol;
    const auto first = std::ranges::find(seen_, symbol, &std::pair<Symbol, NodeId>::first);
    if (first == seen_.end()) {
      seen_.emplace_back(symbol, item);
      return true;
    }
    const SymbolTable& symbols = context_.program.symbols;
    context_.report.add(errors::property_set_twice(ast_.named_span(item, symbols), context_.name(symbol),
                                                   ast_.named_span(first->second, symbols)));
    return false;
  }

private:
  CheckContext& context_;
  const Ast& ast_;
  std::vector<std::pair<Symbol, NodeId>> seen_;
};

} // namespace

void check_property(CheckContext& context, Unit& unit, NodeId item, const Owner& owner) {
  if (owner.is_unknown) return;
  const Symbol symbol = unit.ast.named(item).symbol;
  const Span span = unit.ast.named_span(item, context.program.symbols);
  if (!owner.type) return errors::property_without_thing(context, span, symbol);
  if (owner.def && !owner.is_def_body) {
    if (const auto parameter = owner.def->find(symbol)) {
      const DeclarationId declaration = owner.def->parameters[*parameter].declaration;
      if (declaration != no_declaration) context.program.references.add(span, declaration, Reference::Use::sets);
      return;
    }
  }
  const auto found = owner.type->find(symbol);
  if (!found) return errors::unknown_property(context, unit, item, owner);
  if (!owner.def) unit.ast[item].extra = static_cast<std::uint16_t>(*found + 1);
  context.program.references.add(span, &owner.type->properties[*found], Reference::Use::sets);
}

// Only for properties directly in the block; those that `if` and `for` add are checked at run time.
void check_duplicates(CheckContext& context, const Unit& unit, NodeId block, const Owner& owner) {
  if (!owner.type || owner.is_unknown) return;
  FirstOnes first_ones(context, unit.ast);
  const Property* form_owner = nullptr;
  NodeId form_item = no_node;
  for (const NodeId item : unit.ast.children(block)) {
    if (unit.ast.kind(item) != Kind::property || !first_ones.add(item)) continue;
    const auto found = owner.def ? std::nullopt : owner.type->find(unit.ast.named(item).symbol);
    const Property* property = found ? &owner.type->properties[*found] : nullptr;
    if (!property || property->form == 0) continue;
    if (form_owner && form_owner->form != property->form) {
      const SymbolTable& symbols = context.program.symbols;
      context.report.add(errors::two_forms(unit.ast.named_span(item, symbols), property->name,
                                           unit.ast.named_span(form_item, symbols), form_owner->name));
      continue;
    }
    form_owner = property;
    form_item = item;
  }
}

void check_record_fields(CheckContext& context, const Unit& unit, NodeId record) {
  FirstOnes first_ones(context, unit.ast);
  for (const NodeId item : unit.ast.children(record))
    if (unit.ast.kind(item) == Kind::property) first_ones.add(item);
}

bool is_simple_block(const Unit& unit, NodeId block, const NodeType& type) {
  if (type.is_composite() || unit.ast.children(block).size() > PropertyList::most) return false;
  int form = 0;
  std::uint64_t seen = 0;
  for (const NodeId item : unit.ast.children(block)) {
    const Node& node = unit.ast[item];
    if (node.kind != Kind::property || node.extra == 0 || node.extra > 64) return false;
    const std::uint64_t bit = std::uint64_t{1} << (node.extra - 1);
    const int own_form = type.properties[static_cast<std::size_t>(node.extra - 1)].form;
    if ((seen & bit) != 0 || (form != 0 && own_form != 0 && form != own_form)) return false;
    seen |= bit;
    if (own_form != 0) form = own_form;
  }
  return true;
}

} // namespace rt::lang
