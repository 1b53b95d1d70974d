#pragma once

#include "lang/evaluate/evaluation.hpp"

#include <vector>

namespace rt::lang {

/// An expectation that a run came by.
struct Expectation {
  struct LoopVariable {
    Span name;
    Value value;
  };
  Unit* unit;
  NodeId node;
  Ref<Frame> frame;
  std::vector<LoopVariable> turn; ///< of the loops it stands in, the outermost first
};

/// The expectations that a run comes by, to be tried once the scene is whole.
class ExpectationList {
public:
  /// Unless they are wanted, they are passed over.
  void want() { is_wanted_ = true; }
  bool is_wanted() const { return is_wanted_; }
  void add(const Context& context, NodeId node);
  const std::vector<Expectation>& all() const { return all_; }
  void clear();

  /// While it lives, expectations stand in this turn of a loop.
  class Turn {
  public:
    Turn(ExpectationList& list, const Context& context, NodeId loop) : list_(list) {
      list_.loops_.push_back({&context.ast(), loop, context.frame});
    }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn() { list_.loops_.pop_back(); }

  private:
    ExpectationList& list_;
  };

private:
  struct Loop {
    const Ast* ast;
    NodeId node;
    Frame* frame;
  };

  bool is_wanted_ = false;
  std::vector<Expectation> all_;
  std::vector<Loop> loops_; // the outermost first
};

} // namespace rt::lang
