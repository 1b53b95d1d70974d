#pragma once

#include "lang/evaluate/evaluate.hpp"
#include "lang/evaluate/expectation_runner.hpp"
#include "lang/evaluate/things/thing_evaluator.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rt::lang {

/// The result of one statement of a session.
struct StatementResult {
  std::vector<scene::Object> objects;
  std::vector<scene::Light> lights;
  std::optional<scene::Camera> camera;
  Span camera_place;
  std::optional<Span> sky_place;
  std::vector<PropertyValue> properties; ///< of the scene
  std::optional<Value> printed;          ///< of an expression that is not a thing
  bool is_print = false;                 ///< a call of `print(…)`, which has already produced its output
};

/// Runs a program's files, whole or statement by statement in a session.
class Evaluator : private ThingSource {
public:
  /// `stack_limit` is the lowest address that the stack may reach.
  Evaluator(Program& program, Report& report, const Limits& limits, const std::atomic<bool>* stop,
            const char* stack_limit);
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;
  /// With an observer the expectations are tested once the scene is complete.
  Evaluated run(const ObserverMaker* observe = nullptr);

  // Sessions (evaluate_session.cpp): statements are run one by one, and what they made stays in the scene's tables.
  void begin_session();
  /// Functions added from now on are those of the next input.
  void begin_change() { tried_functions_ = program_.functions.size(); }
  /// Before the statements of an input are run: the limits count from here. `slots` is the number that the session's
  /// frame must have.
  void begin_input(std::uint32_t slots, const char* stack_limit);
  /// `may_print`: an expression that is not a thing is no error.
  StatementResult run_statement(Unit& unit, std::span<const NodeId> nodes, bool may_print);
  /// Finds errors in the input's functions that nothing has called.
  void try_session_functions();
  /// What was printed since the last call.
  std::vector<Diagnostic> take_printed() { return evaluation_.errors.take_printed(); }
  const Value& session_value(std::uint32_t slot) { return (*main_)[slot]; }
  scene::Scene& scene() { return scene_; }
  scene::FieldValue scene_value(const PropertyValue& property) { return writer_.scene_value(property); }

private:
  void run_program();
  void run_library();
  void try_unused_functions();
  void try_function(const FunctionInfo& function);
  void try_body(const FunctionInfo& function, const Context& context);
  void finish_scene();
  bool set_scene_properties();
  void run_nodes(Unit& unit, std::span<const NodeId> nodes, bool may_print, Target& target, StatementResult& made);
  Value module_value(const Context& context, NodeId item);
  Value param_value(const Context& context, NodeId item);
  Value within_range(const Value& value, Span place, const ParamItem& param, const Context& context);

  Value override_value(NodeId node, const Context& context) override { return things_.override_value(node, context); }
  Value combine(Op op, Value left, Value right, NodeId node, const Context& context) override {
    return things_.combine(op, std::move(left), std::move(right), node, context);
  }
  Value moved(const Thing& thing, scene::Step step, Span place) override {
    return things_.moved(thing, std::move(step), place);
  }
  Value declared_value(NodeId item, const Context& context) override;
  const Observer* observer() override { return expectations_.observer(); }
  std::optional<double> precision() const override { return expectations_.precision(); }
  const Observer* observer_of(const Value& thing, Span place) override {
    return expectations_.observer_of(thing, place);
  }

  Evaluation evaluation_;
  Program& program_;
  Report& report_;
  scene::Scene& scene_;
  Ref<Frame> library_, main_;
  std::vector<std::pair<const ModuleInfo*, Value>> modules_;
  PropertyBlock scene_properties_;
  std::size_t tried_functions_ = 0; // in a session: how many of the program's
  ExpectationList expectation_list_;
  SceneWriter writer_;
  ExpressionEvaluator expressions_;
  BlockEvaluator blocks_;
  ThingEvaluator things_;
  ExpectationRunner expectations_;
};

} // namespace rt::lang
