#include "lang/check/scopes.hpp"

#include "lang/check/errors/name_errors.hpp"
#include "lang/check/errors/statement_errors.hpp"

#include <algorithm>

namespace rt::lang {

void Scopes::open(const Unit* unit, NodeId block, const Owner& owner) {
  scopes_.push_back({static_cast<std::uint32_t>(bindings_.size()), unit, block, owner});
}

void Scopes::close() {
  const Scope& scope = scopes_.back();
  for (const Binding& binding : bindings(scope.first_binding)) {
    if (binding.may_be_property && binding.reads == 0)
      errors::name_hides_property(context_, binding.span, binding.name, scope.owner);
  }
  while (bindings_.size() > scope.first_binding) {
    const Binding& binding = bindings_.back();
    innermost_[static_cast<std::size_t>(binding.name)] = binding.shadowed;
    bindings_.pop_back();
  }
  scopes_.pop_back();
}

std::uint32_t Scopes::end_activation() {
  const std::uint32_t slots = activations_.back().slots;
  activations_.pop_back();
  return slots;
}

Binding* Scopes::find(Symbol symbol) {
  const auto i = static_cast<std::size_t>(symbol);
  if (i >= innermost_.size() || innermost_[i] == none) return nullptr;
  return &bindings_[innermost_[i]];
}

Binding& Scopes::declare(Symbol symbol, Span span, Meaning meaning) {
  const auto i = static_cast<std::size_t>(symbol);
  if (i >= innermost_.size()) innermost_.resize(std::max(i + 1, context_.program.symbols.size()), none);
  const auto scope = static_cast<std::uint32_t>(scopes_.size());
  if (const Binding* first = find(symbol);
      first && first->scope == scope && meaning != Meaning::error && first->meaning != Meaning::error) {
    // Functions and nouns are declared before the lines of their block are read: the first may come later in the text.
    const bool is_before = first->span.file == span.file && span.begin < first->span.begin;
    errors::name_bound_twice(context_, symbol, is_before ? span : first->span, is_before ? first->span : span);
  }
  Binding& binding = bindings_.emplace_back();
  binding.meaning = meaning;
  binding.name = symbol;
  binding.span = span;
  binding.scope = scope;
  binding.level = static_cast<std::uint32_t>(activations_.size() - 1);
  binding.shadowed = innermost_[i];
  innermost_[i] = static_cast<std::uint32_t>(bindings_.size() - 1);
  return binding;
}

Binding& Scopes::declare(Unit& unit, NodeId node, Meaning meaning) {
  Binding& binding = declare(unit.ast.symbol(node), unit.ast.span(node), meaning);
  if (meaning == Meaning::function) return binding;
  binding.slot = activations_.back().slots++;
  unit.ast.set_slot(node, binding.slot, pack(Resolution::local, 0));
  return binding;
}

// The nodes of an expression or block are contiguous, the root last; the first is found along the way.
bool has_closure(const Ast& ast, NodeId node) {
  const std::uint32_t begin = ast[node].begin;
  for (auto i = static_cast<std::uint32_t>(node); i-- > 0;) {
    const Node& inner = ast.nodes[i];
    if (inner.begin < begin) return false;
    if (inner.kind == Kind::lambda || inner.kind == Kind::def || inner.kind == Kind::fn ||
        inner.kind == Kind::include || inner.kind == Kind::expect)
      return true;
  }
  return false;
}

void end_loop_frame(CheckContext& context, Scopes& scopes, Unit& unit, NodeId loop) {
  constexpr std::uint32_t most_slots = 0xffff;
  const std::uint32_t slots = scopes.end_activation();
  unit.ast[loop].extra = static_cast<std::uint16_t>(std::min(slots, most_slots));
  if (slots > most_slots) errors::too_many_names_in_loop(context.report, unit.ast.span(loop));
}

} // namespace rt::lang
