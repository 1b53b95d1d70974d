#pragma once

#include "lang/evaluate/evaluator.hpp"

namespace rt::lang {

/// Lets go of a frame at the end of a scope, also when the evaluation ends in the middle of it.
class FrameScope {
public:
  FrameScope(Evaluator& evaluator, Ref<Frame> frame) : evaluator_(evaluator), frame_(std::move(frame)) {}
  FrameScope(const FrameScope&) = delete;
  FrameScope& operator=(const FrameScope&) = delete;
  ~FrameScope() { evaluator_.leave(std::move(frame_)); }
  Frame* get() const { return frame_.get(); }

private:
  Evaluator& evaluator_;
  Ref<Frame> frame_;
};

template <class Body>
void Evaluator::for_each(NodeId node, const Context& context, Body&& body) {
  const ForItem loop = context.ast().for_item(node);
  const std::uint32_t own_frame = context.ast()[node].extra;
  const Value head = expression(loop.head, context);
  const auto turn = [&](double i, Value element) {
    const auto run = [&](const Context& inner) {
      const Ast& ast = inner.ast();
      if (loop.index_name != no_node) (*inner.frame)[ast.slot(loop.index_name)] = i;
      (*inner.frame)[ast.slot(loop.value_name)] = std::move(element);
      body(inner);
    };
    if (own_frame == 0) return run(context);
    const FrameScope frame(*this, make_frame(heap_, Ref<Frame>(context.frame), own_frame));
    run({context.unit, frame.get()});
  };
  if (!is_loop_head(head, loop.head, context)) { // once, to find the mistakes in it
    ++unsure_;
    turn(0, Value::poison());
    --unsure_;
    return;
  }
  const std::size_t size = sequence_size(head);
  for (std::size_t i = 0; i < size; ++i) turn(static_cast<double>(i), sequence_at(head, i));
}

} // namespace rt::lang
