#include "lang/evaluate/evaluator.hpp"
#include "lang/evaluate/evaluator_loops.hpp"
#include "lang/values/properties.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {

Value Evaluator::call_value(NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const rt::lang::Call call = ast.call(node);
  const Node& callee_node = ast[call.callee];
  if (callee_node.kind == Kind::name) { // without making a value of the function
    if (resolution(callee_node) == Resolution::builtin)
      return call_builtin(*all_builtins()[ast.slot(call.callee)], node, context);
    if (resolution(callee_node) == Resolution::question)
      return call_builtin(questions()[ast.slot(call.callee)], node, context);
    if (resolution(callee_node) == Resolution::function) {
      const FunctionInfo& function = program_.functions[ast.slot(call.callee)];
      Frame* frame = context.frame;
      for (std::size_t i = frames_out(callee_node); i > 0; --i) frame = frame->parent.get();
      if (function.kind == Kind::fn) return call_closure(function, frame, node, context);
    }
  }
  Value callee;
  if (callee_node.kind == Kind::member) {
    const Value base = expression(ast.member(call.callee).base, context);
    if (base.is_poison())
      callee = base;
    else if (base.is(ValueKind::thing)) {
      if (const ChainMethod* method = find_chain_method(name(ast.member(call.callee).symbol)))
        return call_chain(base, *method, node, context);
      callee = member_of(base, call.callee, context);
    } else {
      callee = member_of(base, call.callee, context);
    }
  } else {
    callee = expression(call.callee, context);
  }
  if (callee.is(ValueKind::closure))
    return call_closure(*callee.closure().function, callee.closure().parent.get(), node, context);
  if (callee.is(ValueKind::builtin)) return call_builtin(*callee.builtin(), node, context);
  for (const NodeId argument : call.arguments) // there may be mistakes in them
    expression(ast.kind(argument) == Kind::argument ? ast.named(argument).value : argument, context);
  if (callee.is_poison()) return callee;
  if (callee.is(ValueKind::thing))
    return fail("E0209", ast.span(node), fmt::format("{} is a thing, and things take braces", describe(callee)),
                "write `{ … }`");
  return fail("E0306", ast.span(call.callee), "only a function can be called", "this is " + describe(callee));
}

Value Evaluator::call_closure(const FunctionInfo& function, Frame* parent, NodeId node, const Context& context) {
  const Ast& ast = context.ast();
  const Span place = ast.span(node);
  const FrameScope frame(*this, make_frame(heap_, Ref<Frame>(parent), function.frame_size));
  bool is_poison = false;
  std::size_t position = 0;
  const auto complain = [&](Span where, std::string message, std::string label = {}) {
    is_poison = true;
    fail("E0208", where, std::move(message), std::move(label));
  };
  for (const NodeId argument : ast.call(node).arguments) {
    const bool is_named = ast.kind(argument) == Kind::argument;
    Value value = expression(is_named ? ast.named(argument).value : argument, context);
    is_poison |= value.is_poison();
    std::optional<std::size_t> i = position;
    if (is_named)
      i = function.find(ast.named(argument).symbol);
    else
      ++position;
    if (!i) {
      complain(ast.named_span(argument, program_.symbols),
               fmt::format("the function has no parameter `{}`", name(ast.named(argument).symbol)));
    } else if (*i >= function.parameters.size()) {
      complain(ast.span(argument), fmt::format("the function takes {}", count_of_arguments(function.parameters.size())),
               "one too many");
    } else {
      (*frame.get())[function.parameters[*i].slot] = std::move(value);
    }
  }
  if (is_poison || unsure_ > 0) return Value::poison();
  const CallFrame call{&function, place, calls_};
  calls_ = &call;
  Value result = Value::poison();
  enter_call(place);
  if (fill_defaults(function, *frame.get(), place)) result = run_body(function, frame.get());
  --recursion_;
  calls_ = call.caller;
  return result;
}

Value Evaluator::run_body(const FunctionInfo& function, Frame* frame) {
  function.was_run = true;
  return expression(function.body, {function.unit, frame});
}

bool Evaluator::fill_defaults(const FunctionInfo& function, Frame& frame, Span place) {
  for (const FunctionInfo::Parameter& parameter : function.parameters) {
    Value& slot = frame[parameter.slot];
    if (!slot.is(ValueKind::unset)) continue;
    if (parameter.default_value == no_node) {
      fail("E0208", place,
           fmt::format("{} needs a value for `{}`",
                       function.name == no_symbol ? "this function" : fmt::format("`{}`", name(function.name)),
                       name(parameter.name)));
      return false;
    }
    Value value = expression(parameter.default_value, {function.unit, &frame});
    if (value.is_poison()) return false;
    slot = std::move(value);
  }
  return true;
}

Value Evaluator::call_function(const Value& callee, std::vector<Value> arguments, Span place) {
  if (callee.is(ValueKind::builtin)) return call_builtin_with(*callee.builtin(), std::move(arguments), place);
  if (!callee.is(ValueKind::closure))
    return fail("E0306", place, "only a function can be called", "this is " + describe(callee));
  const FunctionInfo& function = *callee.closure().function;
  if (arguments.size() > function.parameters.size()) {
    return fail("E0208", place,
                fmt::format("this function is called with {}, and takes {}", count_of_arguments(arguments.size()),
                            function.parameters.size()));
  }
  const FrameScope frame(*this, make_frame(heap_, callee.closure().parent, function.frame_size));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is_poison()) return Value::poison();
    (*frame.get())[function.parameters[i].slot] = std::move(arguments[i]);
  }
  if (unsure_ > 0) return Value::poison();
  const CallFrame call{&function, place, calls_};
  calls_ = &call;
  Value result = Value::poison();
  enter_call(place);
  if (fill_defaults(function, *frame.get(), place)) result = run_body(function, frame.get());
  --recursion_;
  calls_ = call.caller;
  return result;
}

// A frame whose own values refer to it would never go: a function kept in it, or a thing that a def in it makes.
void Evaluator::leave(Ref<Frame> frame) {
  if (frame->references == 1) return;
  std::uint32_t own = 1;
  bool may_hold_itself = false;
  for (std::uint32_t i = 0; i < frame->size; ++i) {
    const Value& value = (*frame)[i];
    if (!value.is_shared() || value.is(ValueKind::string)) continue;
    may_hold_itself = true;
    if (value.cell()->references != 1) continue;
    if (value.is(ValueKind::closure) && value.closure().parent == frame) ++own;
    if (value.is(ValueKind::thing) && value.thing().def_frame == frame) ++own;
  }
  if (frame->references == own)
    frame->clear();
  else if (may_hold_itself)
    suspects_.push_back(std::move(frame));
  if (suspects_.size() < next_sweep_) return;
  std::erase_if(suspects_, [](const Ref<Frame>& f) { return f->references == 1; });
  next_sweep_ = std::max(next_sweep_, 2 * suspects_.size()); // so that many that stay are not looked at again and again
}

} // namespace rt::lang
