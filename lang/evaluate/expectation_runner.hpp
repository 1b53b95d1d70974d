#pragma once

#include "lang/builtins/expect.hpp"
#include "lang/evaluate/things/block_evaluator.hpp"
#include "lang/evaluate/things/scene_writer.hpp"

#include <memory>
#include <optional>
#include <string>

namespace rt::lang {

/// Tests expectations: observes the scene, or a thing alone, through an observer.
class ExpectationRunner : private EvaluationPart {
public:
  ExpectationRunner(Evaluation& evaluation, ExpressionEvaluator& expressions, BlockEvaluator& blocks,
                    SceneWriter& writer)
      : EvaluationPart(evaluation), scene_(evaluation.builder.scene), expressions_(expressions), blocks_(blocks),
        writer_(writer) {}

  /// Must be called before the first observation.
  void use(const ObserverMaker& make_observer) { make_observer_ = &make_observer; }
  Expectations run(const std::vector<Expectation>& expectations);
  /// Of the scene as it is at the first call.
  const Observer* observer();
  /// The tolerance of the expectation being tested, if it states one.
  std::optional<double> precision() const { return precision_; }
  /// Of a thing alone, which need not be placed in the scene; null after an error.
  const Observer* observer_of(const Value& thing, Span place);
  /// Releases observers and what they observe.
  void clear();

private:
  bool holds(const Expectation& expectation);
  bool holds_true(const Expectation& expectation, const ExpectItem& item);
  bool holds_near(const Expectation& expectation, const ExpectItem& item);
  bool holds_sight(const Expectation& expectation, const ExpectItem& item);
  std::optional<double> tolerance_of(const ExpectItem& item, const Context& context, double expected);
  void fail_expectation(const Expectation& expectation, std::string message, std::string expected, std::string found);
  bool is_seen(const Value& thing, const Sighting& sighting);
  bool is_alone(const Value& thing) const;
  std::string name_of(const Value& thing, NodeId node, const Context& context);

  struct SingleThing {
    Value thing;
    std::unique_ptr<scene::Scene> scene;
    std::unique_ptr<Observer> observer;
  };

  scene::Scene& scene_;
  ExpressionEvaluator& expressions_;
  BlockEvaluator& blocks_;
  SceneWriter& writer_;
  const ObserverMaker* make_observer_ = nullptr;
  std::unique_ptr<Observer> observer_; // of the scene
  SingleThing single_;                 // the thing that was asked about last
  std::optional<double> precision_;
  Expectations outcome_;
};

} // namespace rt::lang
