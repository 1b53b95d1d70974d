#include "lang/check/checker.hpp"

namespace rt::lang {

// Functions are visible throughout, so all of them are declared first; values from their statement on.
void Checker::check_session(std::span<TopItem> items, std::uint32_t& slots, const AddNames& add_further_names) {
  add_further_names_ = &add_further_names;
  is_main_ = true;
  declare_library();
  begin_activation();
  activations_.back().slots = slots;
  top_scope_ = scopes_.size();
  Owner owner;
  owner.type = &program_.types.scene();
  open_scope(nullptr, no_node, owner);
  const auto enter = [this](TopItem& item) {
    top_item_ = &item;
    scopes_.back().unit = item.unit;
    scopes_.back().block = item.unit->ast.root;
    return bindings_.size();
  };
  for (TopItem& item : items) {
    if (!item.unit) {
      declare_known(item, true);
      continue;
    }
    const std::size_t first = enter(item);
    for (const NodeId node : item.nodes) hoist_item(*item.unit, node);
    take_names(item, first);
  }
  for (TopItem& item : items) {
    if (!item.unit) {
      declare_known(item, false);
      continue;
    }
    const std::size_t first = enter(item);
    for (const NodeId node : item.nodes) check_item(*item.unit, node);
    take_names(item, first);
  }
  top_item_ = nullptr;
  close_scope();
  slots = end_activation();
  close_scope();
}

void Checker::declare_known(const TopItem& item, bool functions) {
  for (const TopName& name : item.names) {
    if ((name.meaning == Meaning::function) != functions) continue;
    Binding* binding = declare(name.name, name.span, name.meaning);
    binding->slot = name.slot;
    binding->known = name.known;
  }
}

void Checker::take_names(TopItem& item, std::size_t first) {
  for (std::size_t i = first; i < bindings_.size(); ++i) {
    const Binding& binding = bindings_[i];
    item.names.push_back({binding.what, binding.name, binding.span, binding.slot, binding.known});
  }
}

void Checker::note_use(Symbol symbol, const Binding* binding) {
  if (!binding || binding->scope < top_scope_ + 1)
    top_item_->globals.push_back(symbol);
  else if (binding->scope == top_scope_ + 1)
    top_item_->uses.push_back(symbol);
}

} // namespace rt::lang
