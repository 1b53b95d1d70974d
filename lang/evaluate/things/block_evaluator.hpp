#pragma once

#include "lang/evaluate/expectation_list.hpp"
#include "lang/evaluate/expressions/expression_evaluator.hpp"
#include "lang/evaluate/things/target.hpp"

namespace rt::lang {

class ThingEvaluator;

/// Runs the items of blocks and files: their results go into a target.
class BlockEvaluator : private EvaluationPart {
public:
  BlockEvaluator(Evaluation& evaluation, ExpressionEvaluator& expressions, ThingEvaluator& things,
                 ExpectationList& expectations)
      : EvaluationPart(evaluation), expressions_(expressions), things_(things), expectations_(expectations) {}

  void items(NodeId block, const Context& context, Target& target);
  /// An item nested too deeply does not keep the others from being run, so that all errors of a file are reported.
  void file_items(NodeId root, const Context& context, Target& target);
  void item(NodeId node, const Context& context, Target& target);
  void put(const Value& value, Span place, Target& target);
  /// False if `run` nests too deeply; inside a call the outermost call is abandoned.
  template <class F>
  bool ends_in_time(F&& run);

private:
  void repeat(NodeId node, const Context& context, Target& target);
  void loop_items(NodeId node, const Context& context, Target& target);
  void if_item(NodeId node, const Context& context, Target& target);
  void property_item(NodeId node, const Context& context, Target& target);
  void fail_unknown_property(const PropertyBlock& block, Symbol property, Span place);
  bool is_written(const PropertyBlock& block, std::uint16_t id, std::string_view word, Span name_place);
  void set_property(PropertyBlock& block, std::uint16_t id, Value value, Span place, Span name_place);
  void put_comprehension(const Comprehension& parts, std::size_t clause, const Context& context, Target& target);

  ExpressionEvaluator& expressions_;
  ThingEvaluator& things_;
  ExpectationList& expectations_;
};

template <class F>
bool BlockEvaluator::ends_in_time(F&& run) {
  const bool is_in_call = errors_.is_in_call();
  try {
    run();
    return true;
  } catch (const LimitGuard::TooDeep&) {
    if (is_in_call) throw;
    return false;
  }
}

} // namespace rt::lang
