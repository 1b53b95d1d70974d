#include "lang/evaluate/expectation_list.hpp"

namespace rt::lang {

void ExpectationList::add(const Context& context, NodeId node) {
  Expectation& expectation = all_.emplace_back(Expectation{context.unit, node, Ref<Frame>(context.frame), {}});
  for (const Loop& loop : loops_) {
    const ForItem item = loop.ast->for_item(loop.node);
    for (const NodeId name : {item.index_name, item.value_name})
      if (name != no_node) expectation.turn.push_back({loop.ast->span(name), (*loop.frame)[loop.ast->slot(name)]});
  }
}

void ExpectationList::clear() {
  all_.clear();
  loops_.clear();
}

} // namespace rt::lang
