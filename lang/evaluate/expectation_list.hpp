#pragma once

#include "lang/evaluate/evaluation.hpp"

#include <vector>

namespace rt::lang {

/// An expectation encountered during a run.
struct Expectation {
  struct LoopVariable {
    Span name;
    Value value;
  };
  Unit* unit;
  NodeId node;
  Ref<Frame> frame;
  std::vector<LoopVariable> turn; ///< of the enclosing loops, outermost first
};

/// The expectations encountered during a run, to be tested once the scene is complete.
class ExpectationList {
public:
  /// Without this call they are skipped.
  void want() { is_wanted_ = true; }
  bool is_wanted() const { return is_wanted_; }
  void add(const Context& context, NodeId node);
  const std::vector<Expectation>& all() const { return all_; }
  void clear();

  /// During its lifetime, expectations belong to this loop iteration.
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
  std::vector<Loop> loops_; // outermost first
};

} // namespace rt::lang
