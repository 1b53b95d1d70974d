#pragma once

#include "lang/builtins/builtins.hpp"
#include "lang/evaluate/description.hpp"
#include "lang/evaluate/evaluate.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rt::lang {

/// Where an expression is evaluated: its text and the names around it.
struct Context {
  Unit* unit;
  Frame* frame;
  Ast& ast() const { return unit->ast; }
};

/// Properties as they come in, for a thing or for the scene.
struct PropertyBlock {
  const NodeType* type = nullptr;
  const FunctionInfo* def = nullptr; ///< its parameters come first
  std::vector<PropertyValue> values; ///< to begin with, what is inherited
  struct Written {
    std::uint16_t id;
    Span name;
  };
  std::vector<Written> written; ///< in this block
  bool is_broken = false;       ///< part of the block is in error, so that what it describes is not known
};

/// What the items of a block are put into.
struct Target {
  enum class Kind : std::uint8_t {
    scene,
    content,  ///< of a group, a combination or a def
    bare,     ///< the block of a thing that nothing can be put into
    discarded ///< the top level of a file that `use` reads
  };
  Kind kind = Kind::bare;
  std::vector<scene::Object>* objects = nullptr;
  std::vector<scene::Light>* lights = nullptr;
  const NodeType* type = nullptr;      ///< the composite that is filled
  PropertyBlock* properties = nullptr; ///< null where the block is of something in error
  std::uint16_t depth = 0;             ///< of what was put in
  std::uint32_t things = 0;            ///< how many were put in
  bool is_first_missing = false;       ///< the first operand is nothing
  bool is_one_missing = false;         ///< an operand is nothing
  Span owner;                          ///< the thing whose block it is, for messages
};

/// What one statement of a session made.
struct StatementResult {
  std::vector<scene::Object> objects;
  std::vector<scene::Light> lights;
  std::optional<scene::Camera> camera;
  Span camera_place;
  std::vector<PropertyValue> properties; ///< of the scene
  std::optional<Value> printed;          ///< of an expression that is no thing
};

/// The pass that runs a program. One per run, or per session.
class Evaluator {
public:
  /// `stack_limit` is the lowest address that the stack may reach.
  Evaluator(Program& program, Report& report, const Limits& limits, const std::atomic<bool>* stop,
            const char* stack_limit);
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;
  ~Evaluator();
  /// With an observer the expectations are tried once the scene is whole.
  Evaluated run(const ObserverMaker* observe = nullptr);

  // Sessions (evaluate_session.cpp): statements are run one by one, and what they made stays in the scene's tables.
  void begin_session();
  /// Functions that come from now on are those of the next input.
  void begin_change() { tried_functions_ = program_.functions.size(); }
  /// Before the statements of an input are run: the limits count from here. `slots` is how many the session's frame
  /// must have.
  void begin_input(std::uint32_t slots, const char* stack_limit);
  /// `may_print`: an expression that is no thing is no mistake.
  StatementResult run_statement(Unit& unit, std::span<const NodeId> nodes, bool may_print);
  /// Finds mistakes in the input's functions that nothing has called.
  void try_session_functions();
  const Value& session_value(std::uint32_t slot) { return (*main_)[slot]; }
  scene::Scene& scene() { return scene_; }
  scene::FieldValue scene_value(const PropertyValue& property) {
    return writer_.field_value(scene_properties_.type->properties[property.id], property.value);
  }

private:
  friend class ArgumentList;
  friend class FrameScope;

  /// Ends the evaluation: a limit is passed, and reported.
  struct Ended {};
  /// Ends the evaluation of one item of a file: calls or things are nested too deep. The other items are not concerned.
  struct TooDeep : Ended {};
  struct CallFrame {
    const FunctionInfo* function;
    Span place;
    const CallFrame* caller;
  };

  // Files and functions (evaluate.cpp)
  void run_program();
  void run_library();
  void try_unused_functions();
  void try_function(const FunctionInfo& function);
  Value module_value(const Context& context, NodeId item);
  Value param_value(const Context& context, NodeId item);
  Value within_range(const Value& value, Span place, const ParamItem& param, const Context& context);
  void finish_scene();

  // Limits (limits.cpp)
  void spend(std::uint64_t steps, Span place) {
    steps_ += steps;
    if (steps_ >= next_look_) look_at_limits(place);
  }
  void look_at_limits(Span place);
  void reserve(std::uint64_t bytes, Span place);
  std::uint64_t bytes_in_use() const;
  void count_objects(std::size_t count, Span place);
  void check_depth(std::uint16_t depth, Span place);
  void enter_call(Span place);
  [[noreturn]] void end(std::string_view code, std::string message, std::string label, Span place);
  [[noreturn]] void give_up(std::string_view code, std::string message, std::string label, Span place);
  template <class F>
  bool ends_in_time(F&& run);

  // Messages
  Diagnostic* error(std::string_view code, Span place);
  Value fail(std::string_view code, Span place, std::string message, std::string label = {}, std::string advice = {});
  void tell(const Mistake& mistake, Span place);
  std::string_view name(Symbol symbol) const { return program_.symbols.name(symbol); }

  // Expressions (evaluate_expression.cpp)
  Value expression(NodeId node, const Context& context);
  Value name_value(NodeId node, const Context& context);
  Value function_value(const FunctionInfo& function, Frame* frame, Span place);
  Value list_value(NodeId node, const Context& context);
  Value record_value(NodeId node, const Context& context);
  Value comprehension_value(NodeId node, const Context& context);
  void comprehend(const Comprehension& parts, std::size_t clause, const Context& context, std::vector<Value>& items,
                  Charge& memory);
  Value index_value(NodeId node, const Context& context);
  Value member_value(NodeId node, const Context& context);
  Value member_of(const Value& base, NodeId node, const Context& context);
  Value thing_member(const Thing& thing, NodeId node, const Context& context);
  Value range_value(NodeId node, const Context& context);
  Value if_value(NodeId node, const Context& context);
  Value value_block(NodeId block, const Context& context);
  void declaration(NodeId item, const Context& context);
  bool is_true(NodeId condition, const Context& context, bool& is_poison);

  // Operators (operators.cpp)
  Value unary_value(NodeId node, const Context& context);
  Value binary_value(NodeId node, const Context& context);
  Value logic_value(NodeId node, const Context& context);
  Value arithmetic(Op op, const Value& left, const Value& right, Span place);
  Value vector_arithmetic(Op op, const Value& left, const Value& right, Span place);
  Value color_arithmetic(Op op, const Color& left, const Color& right, Span place);
  Value comparison(Op op, const Value& left, const Value& right, Span place);
  Value wrong_operands(Op op, const Value& left, const Value& right, Span place);

  // Calls (evaluate_call.cpp)
  Value call_value(NodeId node, const Context& context);
  Value call_closure(const FunctionInfo& function, Frame* parent, NodeId node, const Context& context);
  Value call_function(const Value& function, std::vector<Value> arguments, Span place);
  Value run_body(const FunctionInfo& function, Frame* frame);
  Value call_builtin(const Builtin& builtin, NodeId node, const Context& context);
  Value call_builtin_with(const Builtin& builtin, std::vector<Value> values, Span place);
  Value call_chain(const Value& base, const ChainMethod& method, NodeId node, const Context& context);
  bool fill_defaults(const FunctionInfo& function, Frame& frame, Span place);
  void leave(Ref<Frame> frame);

  // Blocks and things (evaluate_block.cpp)
  void items(NodeId block, const Context& context, Target& target);
  void file_items(NodeId root, const Context& context, Target& target);
  void item(NodeId node, const Context& context, Target& target);
  void repeat(NodeId node, const Context& context, Target& target);
  void for_item(NodeId node, const Context& context, Target& target);
  void if_item(NodeId node, const Context& context, Target& target);
  void property_item(NodeId node, const Context& context, Target& target);
  void set_property(PropertyBlock& gathered, std::uint16_t id, Value value, Span place, Span name_place);
  void put(const Value& value, Span place, Target& target);
  void put_comprehension(const Comprehension& parts, std::size_t clause, const Context& context, Target& target);
  /// Calls body(context) for each element of the head of a `for`, its variables set.
  template <class Body>
  void for_each(NodeId node, const Context& context, Body&& body);
  bool is_loop_head(const Value& head, NodeId node, const Context& context);

  // Things (things.cpp)
  Value override_value(NodeId node, const Context& context);
  Value simple_thing(NodeId node, const Context& context);
  void simple_properties(NodeId node, const Context& context, const NodeType& type, PropertyList& properties);
  Value changed_thing(Value base, NodeId node, const Context& context);
  Value changed_record(const Record& base, NodeId node, const Context& context);
  Value as_material(const Record& record, Span place);
  void fail_unknown_material_property(const Record::RecordEntry& entry);
  Ref<Thing> new_thing(const NodeType& type, Span place);
  Ref<Thing> copy_of(const Thing& thing);
  static void give_name(Thing& thing, Symbol symbol);
  scene::NameId default_name(Symbol symbol);
  void set_depth(Thing& thing, Span place);
  static constexpr std::uint16_t most_depth = 1'000;
  static constexpr std::size_t most_instances = 1 << 16;
  Ref<Content> content_cell(const Thing& thing);
  Ref<Content> content(const Thing& thing);
  static bool is_same_instance(const Thing& known, const Thing& thing);
  void run_def(const Thing& thing, Content& content);
  void begin_with(const Content& old, const NodeType& type, Content& members, Target& target);
  void finish_content(Content& content, const NodeType& type, const Target& target, Span place);

  // Putting things into the scene (placing.cpp)
  struct ThingView {
    const NodeType* type;
    std::span<const PropertyValue> properties;
    const Chain* chain;
    Span place;
    const Thing* thing; ///< null for what was never a value
  };
  void put_thing(const ThingView& described, Target& target);
  void put_simple(NodeId node, const Context& context, Target& target);
  void put_shape(const ThingView& described, Target& target);
  void put_light(const ThingView& described, Target& target);
  void put_camera(const ThingView& described, Target& target);
  std::optional<scene::ShapeRef> shape(const ThingView& described);
  std::optional<scene::ShapeRef> shared_shape(const Thing& thing);
  bool make(const ThingView& described, void* room);
  std::optional<ObjectAttributes> attributes_of(const ThingView& described, const Content* content);
  std::optional<scene::ShapeRef> content_shape(Content& content, const NodeType& type, Span place);
  void remember_places(Span place);
  void fail_flattened(Span place);
  void remark_medium(const ThingView& described, const Content* content, scene::ShapeRef made);
  bool is_operand(const ThingView& described, scene::ShapeRef made);
  void put_lights_of(const Content& inside, const ObjectAttributes& attributes, const ThingView& described,
                     Target& target);
  static bool is_poisoned(std::span<const PropertyValue> properties);

  // Solids (solids.cpp)
  Value combine(Op op, Value left, Value right, NodeId node, const Context& context);
  void begin_with_operands(const Content& old, bool has_members, Content& content, Target& target);
  void add_operand(const Value& value, Span place, Target& target);
  void check_media(const std::vector<scene::Object>& objects);

  // Expectations (expectations.cpp)
  struct LoopVariable {
    Span name;
    Value value;
  };
  struct Expectation {
    Unit* unit;
    NodeId node;
    Ref<Frame> frame;
    std::vector<LoopVariable> turn; // of the loops it stands in, the outermost first
  };
  // A loop of items that is being run, while there is somebody to look.
  struct Loop {
    const Ast* ast;
    NodeId node;
    Frame* frame;
  };
  void loop_items(NodeId node, const Context& context, Target& target);
  std::vector<LoopVariable> turn_of_loops() const;
  void run_expectations();
  bool holds(const Expectation& expectation);
  bool holds_true(const Expectation& expectation, const ExpectItem& item);
  bool holds_near(const Expectation& expectation, const ExpectItem& item);
  bool holds_sight(const Expectation& expectation, const ExpectItem& item);
  std::optional<double> tolerance_of(const ExpectItem& item, const Context& context, double expected);
  void fail_expectation(const Expectation& expectation, std::string message, std::string expected, std::string found);
  bool is_seen(const Value& thing, const Sighting& sighting);
  std::string name_of(const Value& thing, NodeId node, const Context& context);
  const Observer* observer();
  const Observer* observer_of(const Value& thing, Span place);

  Program& program_;
  Report& report_;
  const Limits& limits_;
  const std::atomic<bool>* stop_;
  Heap heap_;
  scene::Builder builder_;
  scene::Scene& scene_ = builder_.scene;
  DescriptionWriter writer_;

  std::uint64_t steps_ = 0;
  std::uint64_t next_look_ = 0;
  std::uint64_t objects_ = 0;
  int recursion_ = 0;
  const CallFrame* calls_ = nullptr;
  const char* stack_limit_;
  int unsure_ = 0; // above 0: a condition is in error, so that what is read may never run; nothing is built

  Ref<Frame> library_, main_;
  std::vector<std::pair<const ModuleInfo*, Value>> modules_;
  std::vector<Ref<Frame>> suspects_;                             // frames that may be kept alive by what they hold
  std::size_t next_sweep_ = std::size_t{1} << 14;                // how many of them are looked through next
  std::unordered_multimap<std::uint64_t, Ref<Thing>> instances_; // things of defs whose body was run, by arguments
  PropertyBlock scene_properties_;
  std::optional<Span> camera_place_;
  std::vector<Span> combination_places_;     // by index of the combination
  std::size_t tried_functions_ = 0;          // in a session: so many of the program's
  std::vector<scene::NameId> default_names_; // by symbol: once they were needed
  std::vector<Expectation> expectations_;
  std::vector<Loop> loops_; // the outermost first
  Expectations outcome_;
  const ObserverMaker* make_observer_ = nullptr; // null: expectations are passed over
  std::unique_ptr<Observer> observer_;           // of the scene
  struct SingleExpression {
    Value thing;
    std::unique_ptr<scene::Scene> scene;
    std::unique_ptr<Observer> observer;
  };
  SingleExpression alone_;     // the thing that was asked about last
  bool has_leftovers_ = false; // shapes may have been made that stand nowhere
};

} // namespace rt::lang
