#pragma once

#include "lang/evaluate/expressions/expression_evaluator.hpp"
#include "lang/evaluate/expressions/function_compiler.hpp"
#include "lang/evaluate/things/scene_writer.hpp"

#include <unordered_map>

namespace rt::lang {

class BlockEvaluator;

/// Makes things: copies with changes, the contents of defs and combinations.
class ThingEvaluator : private EvaluationPart {
public:
  ThingEvaluator(Evaluation& evaluation, ExpressionEvaluator& expressions, BlockEvaluator& blocks, SceneWriter& writer)
      : EvaluationPart(evaluation), expressions_(expressions), blocks_(blocks), writer_(writer),
        compiler_(evaluation, expressions) {}

  Value override_value(NodeId node, const Context& context);
  Value combine(Op op, const Value& left, const Value& right, NodeId node, const Context& context);
  Value moved(const Thing& thing, scene::Step step, Span place);
  /// Makes a value what the property takes: a material of a record, a compiled function; poison after a mistake.
  void prepare(const Property& property, Value& value, Span place);
  /// A material of a record's fields.
  Value as_material(const Record& record, Span place);

  void put(const Thing& thing, Target& target);
  /// Adds a thing that is never a value: a literal with properties only.
  void put_simple(NodeId node, const Context& context, Target& target);

private:
  static constexpr std::size_t most_instances = 1 << 16;

  Value simple_thing(NodeId node, const Context& context);
  void simple_properties(NodeId node, const Context& context, const NodeType& type, PropertyList& properties);
  Value changed_thing(const Thing& old, NodeId node, const Context& context);
  void share_inside(const Thing& old, const PropertyBlock& block, Thing& thing);
  Value changed_record(const Record& base, NodeId node, const Context& context);
  void fail_unknown_material_property(const Record::RecordEntry& entry);
  Ref<Thing> copy_of(const Thing& thing);
  void set_depth(Thing& thing, Span place);
  Ref<Content> content_cell(const Thing& thing);
  Ref<Content> content(const Thing& thing);
  static bool is_same_instance(const Thing& known, const Thing& thing);
  void run_def(const Thing& thing, Content& content);
  void begin_with(const Content& old, const NodeType& type, Content& members, Target& target);
  void finish_content(Content& content, const NodeType& type, const Target& target, Span place);
  void begin_with_operands(const Content& old, bool has_members, Content& content, Target& target);
  void add_operand(const Value& value, Span place, Target& target);

  ExpressionEvaluator& expressions_;
  BlockEvaluator& blocks_;
  SceneWriter& writer_;
  FunctionCompiler compiler_;
  std::unordered_multimap<std::uint64_t, Ref<Thing>> instances_; // things of defs whose body was run, by arguments
};

} // namespace rt::lang
