#pragma once

#include "lang/builtins/expect.hpp"
#include "lang/evaluate/things/block_evaluator.hpp"
#include "lang/evaluate/things/scene_writer.hpp"

#include <memory>
#include <optional>
#include <string>

namespace rt::lang {

/// Tries expectations: looks at the scene, or at a thing alone, through an observer.
class ExpectationRunner : private EvaluationPart {
public:
  ExpectationRunner(Evaluation& evaluation, ExpressionEvaluator& expressions, BlockEvaluator& blocks,
                    SceneWriter& writer)
      : EvaluationPart(evaluation), scene_(evaluation.builder.scene), expressions_(expressions), blocks_(blocks),
        writer_(writer) {}

  /// There must be an observer before anybody looks.
  void use(const ObserverMaker& make_observer) { make_observer_ = &make_observer; }
  Expectations run(const std::vector<Expectation>& expectations);
  /// Of the scene as it is when it is asked for first.
  const Observer* observer();
  /// How near the expectation that is being tried wants to see two values, where it says so.
  std::optional<double> precision() const { return precision_; }
  /// Of a thing alone, which need not stand in the scene; null after a mistake.
  const Observer* observer_of(const Value& thing, Span place);
  /// Lets go of observers and of what they look at.
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
