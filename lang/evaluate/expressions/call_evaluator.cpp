#include "lang/evaluate/expressions/call_evaluator.hpp"

#include "lang/check/errors/argument_errors.hpp"
#include "lang/check/errors/shared_errors.hpp"
#include "lang/evaluate/errors/evaluate_errors.hpp"
#include "lang/evaluate/expressions/argument_list.hpp"
#include "lang/evaluate/expressions/expression_evaluator.hpp"

#include <fmt/format.h>

namespace rt::lang {

Value CallEvaluator::call_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const NodeId callee = ast.call(node).callee;
  if (ast.kind(callee) == Kind::name) { // without creating a function value
    const Node& name_node = ast[callee];
    if (resolution(name_node) == Resolution::builtin)
      return call_builtin(*all_builtins()[ast.slot(callee)], node, context);
    if (resolution(name_node) == Resolution::question)
      return call_builtin(questions()[ast.slot(callee)], node, context);
    if (resolution(name_node) == Resolution::function) {
      const FunctionInfo& function = program_.functions[ast.slot(callee)];
      Frame* frame = context.frame;
      for (std::size_t i = frames_out(name_node); i > 0; --i) frame = frame->parent.get();
      if (function.kind == Kind::fn) return call_closure(function, frame, node, context);
    }
  }
  if (ast.kind(callee) != Kind::member) return call(expressions_.evaluate(callee, context), node, context);
  const Value base = expressions_.evaluate(ast.member(callee).base, context);
  if (base.is_poison()) return call(base, node, context);
  if (base.is(ValueKind::thing)) {
    if (const ChainMethod* method = find_chain_method(name(ast.member(callee).symbol)))
      return call_chain(base, *method, node, context);
  }
  return call(expressions_.member_of(base, callee, context), node, context);
}

Value CallEvaluator::call(const Value& callee, NodeId node, const Context& context) {
  if (callee.is(ValueKind::closure))
    return call_closure(*callee.closure().function, callee.closure().parent.get(), node, context);
  if (callee.is(ValueKind::builtin)) return call_builtin(*callee.builtin(), node, context);
  const Ast& ast = context.ast();
  for (const NodeId argument : ast.call(node).arguments) // there may be errors in them
    expressions_.evaluate(ast.kind(argument) == Kind::argument ? ast.named(argument).value : argument, context);
  if (callee.is_poison()) return callee;
  if (callee.is(ValueKind::thing)) return fail(errors::called_thing(ast.span(node), describe(callee), "write `{ … }`"));
  return fail(errors::not_callable(ast.span(ast.call(node).callee), "only a function can be called",
                                   "this is " + describe(callee)));
}

Value CallEvaluator::call_closure(const FunctionInfo& function, Frame* parent, NodeId node, const Context& context) {
  const FrameScope frame(evaluation_.frames, make_frame(heap_, Ref<Frame>(parent), function.frame_size));
  if (!pass_arguments(function, *frame.get(), node, context)) return Value::poison();
  return run(function, *frame.get(), context.ast().span(node));
}

bool CallEvaluator::pass_arguments(const FunctionInfo& function, Frame& frame, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const auto callee = [&] { return errors::callee(program_.symbols, function); };
  bool is_fine = true;
  std::size_t position = 0;
  for (const NodeId argument : ast.call(node).arguments) {
    const bool is_named = ast.kind(argument) == Kind::argument;
    Value value = expressions_.evaluate(is_named ? ast.named(argument).value : argument, context);
    is_fine &= !value.is_poison();
    const std::optional<std::size_t> i = is_named ? function.find(ast.named(argument).symbol) : position++;
    if (i && *i < function.parameters.size()) {
      Value& slot = frame[function.parameters[*i].slot];
      if (is_named && !slot.is(ValueKind::unset))
        is_fine = refuse(errors::argument_given_twice(ast.named_span(argument, program_.symbols), callee(),
                                                      name(ast.named(argument).symbol)));
      slot = std::move(value);
    } else if (is_named) {
      is_fine = refuse(errors::unknown_parameter(ast.named_span(argument, program_.symbols), callee(),
                                                 name(ast.named(argument).symbol)));
    } else {
      is_fine = refuse(errors::too_many_arguments(ast.span(argument), callee()));
    }
  }
  return is_fine;
}

// The frame contains the arguments.
Value CallEvaluator::run(const FunctionInfo& function, Frame& frame, Span place) {
  if (errors_.is_unsure()) return Value::poison();
  const ErrorReporter::TracedCall call(errors_, function, place);
  const LimitGuard::NestedCall depth(limits_, place);
  if (!fill_defaults(function, frame, place)) return Value::poison();
  function.was_run = true;
  return expressions_.evaluate(function.body, {function.unit, &frame});
}

bool CallEvaluator::fill_defaults(const FunctionInfo& function, Frame& frame, Span place) {
  for (const FunctionInfo::Parameter& parameter : function.parameters) {
    Value& slot = frame[parameter.slot];
    if (!slot.is(ValueKind::unset)) continue;
    if (parameter.default_value == no_node)
      return refuse(errors::missing_argument(place, errors::callee(program_.symbols, function), name(parameter.name)));
    Value value = expressions_.evaluate(parameter.default_value, {function.unit, &frame});
    if (value.is_poison()) return false;
    slot = std::move(value);
  }
  return true;
}

Value CallEvaluator::call_function(const Value& callee, std::vector<Value> arguments, Span place) {
  if (callee.is(ValueKind::builtin)) return call_builtin_with(*callee.builtin(), std::move(arguments), place);
  if (!callee.is(ValueKind::closure))
    return fail(errors::not_callable(place, "only a function can be called", "this is " + describe(callee)));
  const FunctionInfo& function = *callee.closure().function;
  if (arguments.size() > function.parameters.size())
    return fail(errors::called_with_too_many(place, errors::callee(program_.symbols, function), arguments.size()));
  const FrameScope frame(evaluation_.frames, make_frame(heap_, callee.closure().parent, function.frame_size));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is_poison()) return Value::poison();
    (*frame.get())[function.parameters[i].slot] = std::move(arguments[i]);
  }
  return run(function, *frame.get(), place);
}

Value CallEvaluator::call_builtin(const Builtin& builtin, NodeId node, const Context& context) {
  const Span place = context.ast().span(node);
  ArgumentList arguments(evaluation_, *this, things_, builtin.name, builtin.signature, place, builtin.formula);
  return arguments.read(node, context, expressions_) ? run_builtin(builtin, arguments, place) : Value::poison();
}

Value CallEvaluator::call_builtin_with(const Builtin& builtin, std::vector<Value> values, Span place) {
  ArgumentList arguments(evaluation_, *this, things_, builtin.name, builtin.signature, place, builtin.formula);
  return arguments.take(std::move(values)) ? run_builtin(builtin, arguments, place) : Value::poison();
}

Value CallEvaluator::run_builtin(const Builtin& builtin, BuiltinCall& arguments, Span place) {
  if (evaluation_.compiled && holds_formula(arguments.arguments)) return formulas_.call(builtin, arguments, place);
  return builtin.function(arguments);
}

Value CallEvaluator::call_chain(const Value& base, const ChainMethod& method, NodeId node, const Context& context) {
  const Span place = context.ast().span(node);
  ArgumentList arguments(evaluation_, *this, things_, method.name, method.signature, place);
  if (!arguments.read(node, context, expressions_)) return Value::poison();
  const Thing& thing = base.thing();
  if (!thing.type->has_chain())
    return fail(errors::not_movable(
        place, fmt::format("{} cannot be moved with `.{}`", describe(base), method.name), {},
        thing.type->category == Category::camera ? "a camera is placed by `at` and `look_at`" : ""));
  std::optional<scene::Step> step = method.function(arguments);
  if (!step) return Value::poison();
  return things_.moved(thing, *std::move(step), place);
}

} // namespace rt::lang
