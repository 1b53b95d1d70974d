#include "lang/check/expressions.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/check/calls.hpp"
#include "lang/check/errors/call_errors.hpp"
#include "lang/check/errors/statement_errors.hpp"
#include "lang/check/items.hpp"
#include "lang/check/properties.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {
namespace {

void add_property_reference(References& references, Span span, Symbol property, const StaticType& thing) {
  const auto parameter = thing.function ? thing.function->find(property) : std::nullopt;
  if (parameter && thing.function->parameters[*parameter].declaration != no_declaration)
    references.add(span, thing.function->parameters[*parameter].declaration, Reference::Use::reads_part);
  else if (const auto found = thing.type->find(property))
    references.add(span, &thing.type->properties[*found]);
}

/// The words that properties of this name take, whatever the thing: a record does not say what it describes.
std::span<const std::string_view> choices_of(const Program& program, Symbol property) {
  for (const NodeType& type : program.types.all())
    if (const auto found = type.find(property); found && !type.properties[*found].choices.empty())
      return type.properties[*found].choices;
  return {};
}

} // namespace

StaticType ExpressionChecker::check(Unit& unit, NodeId node) {
  switch (unit.ast.kind(node)) {
  case Kind::name:
    return names_.resolve(unit, node);
  case Kind::lambda:
    return check_lambda(unit, node);
  case Kind::call:
    return check_call(unit, node);
  case Kind::member:
    return check_member(unit, node, false);
  case Kind::override_:
    return check_override(unit, node);
  case Kind::binary:
    return check_binary(unit, node);
  case Kind::if_:
    return check_if(unit, node);
  default:
    check_parts(unit, node);
    return {};
  }
}

// Expressions about whose value nothing is known before it is computed.
void ExpressionChecker::check_parts(Unit& unit, NodeId node) {
  const Ast& ast = unit.ast;
  switch (ast.kind(node)) {
  case Kind::list:
    for (const NodeId child : ast.children(node)) check(unit, child);
    return;
  case Kind::record:
    for (const NodeId item : ast.children(node)) {
      if (ast.kind(item) != Kind::property) continue;
      names_.set_choices(choices_of(context_.program, ast.named(item).symbol));
      check(unit, ast.named(item).value);
      names_.set_choices({});
    }
    return check_record_fields(context_, unit, node);
  case Kind::comprehension:
    return check_comprehension(unit, node);
  case Kind::index: {
    const Index index = ast.index(node);
    check(unit, index.base);
    check(unit, index.index);
    return;
  }
  case Kind::unary:
    check(unit, ast.operand(node));
    return;
  case Kind::range: {
    const Range range = ast.range(node);
    check(unit, range.from);
    check(unit, range.to);
    if (range.step != no_node) check(unit, range.step);
    return;
  }
  case Kind::block:
    return items_.check_value_block(unit, node, "this block");
  default:
    return;
  }
}

StaticType ExpressionChecker::check_binary(Unit& unit, NodeId node) {
  const StaticType left = check(unit, unit.ast.left(node));
  check(unit, unit.ast.right(node));
  StaticType known;
  if (!left.is_thing() || !left.type->is_shape()) return known;
  using Operation = scene::Combination::Operation;
  const Op op = unit.ast.op(node);
  if (op != Op::unite && op != Op::intersect && op != Op::subtract) return known;
  known.what = StaticType::What::thing;
  known.type = &context_.program.types.combination(op == Op::unite       ? Operation::unite
                                                   : op == Op::intersect ? Operation::intersect
                                                                         : Operation::subtract);
  return known;
}

StaticType ExpressionChecker::check_if(Unit& unit, NodeId node) {
  const IfNode branch = unit.ast.if_node(node);
  check(unit, branch.condition);
  const auto check_branch = [&](NodeId body) {
    if (unit.ast.kind(body) == Kind::block)
      items_.check_value_block(unit, body, "a branch of an `if` that is a value");
    else
      check(unit, body);
  };
  check_branch(branch.then);
  if (branch.otherwise != no_node)
    check_branch(branch.otherwise);
  else
    errors::if_without_else(context_.report, unit.ast.span(node));
  return {};
}

StaticType ExpressionChecker::check_lambda(Unit& unit, NodeId node) {
  FunctionInfo& info = add_function(context_, unit, node);
  const NameResolver::BeingBound outer = names_.being_bound();
  items_.check_function(unit, info);
  names_.set_being_bound(outer);
  StaticType known;
  known.what = StaticType::What::function;
  known.function = &info;
  return known;
}

// A name is looked up among the questions and the chain methods too, unless the scene has bound it.
StaticType ExpressionChecker::check_callee(Unit& unit, NodeId callee) {
  Ast& ast = unit.ast;
  if (ast.kind(callee) == Kind::member) return check_member(unit, callee, true);
  if (ast.kind(callee) != Kind::name || scopes_.find(ast.symbol(callee))) return check(unit, callee);
  if (const auto question = names_.resolve_question(unit, callee)) return *question;
  const std::string_view word = context_.name(ast.symbol(callee));
  if (!find_chain_method(word)) return check(unit, callee);
  ast.set_slot(callee, 0, pack(Resolution::none, 0));
  errors::method_without_thing(context_, ast.span(callee), word);
  return {};
}

StaticType ExpressionChecker::check_call(Unit& unit, NodeId node) {
  const Ast& ast = unit.ast;
  const Call call = ast.call(node);
  const StaticType callee = check_callee(unit, call.callee);
  for (const NodeId argument : call.arguments)
    check(unit, ast.kind(argument) == Kind::argument ? ast.named(argument).value : argument);
  check_arguments(context_, unit, node, callee);
  // A chain method returns the thing it was called on, with one more step.
  if (ast.kind(call.callee) == Kind::member && callee.is_thing()) return callee;
  return {};
}

StaticType ExpressionChecker::check_member(Unit& unit, NodeId node, bool is_called) {
  const Member member = unit.ast.member(node);
  const bool reads_part = !is_called && unit.ast.kind(member.base) == Kind::name;
  StaticType base =
      reads_part ? names_.resolve(unit, member.base, Reference::Use::reads_part) : check(unit, member.base);
  if (base.what == StaticType::What::module) return check_export(unit, node, *base.module);
  const std::string_view word = context_.name(member.symbol);
  const Span span = unit.ast.member_span(node, context_.program.symbols);
  if (const ChainMethod* method = is_called ? find_chain_method(word) : nullptr) {
    context_.program.references.add(span, method);
    base.is_bare_noun = false;
    return base.is_thing() ? base : StaticType{};
  }
  if (!base.is_thing()) return {};
  if (is_called)
    errors::unknown_method(context_, span, word);
  else
    add_property_reference(context_.program.references, span, member.symbol, base);
  return {};
}

StaticType ExpressionChecker::check_export(Unit& unit, NodeId node, const ModuleInfo& module) {
  const Symbol symbol = unit.ast.member(node).symbol;
  const Span span = unit.ast.member_span(node, context_.program.symbols);
  const ModuleInfo::Export* found = module.find(symbol);
  StaticType known;
  if (!found) {
    errors::unknown_export(context_, span, symbol, module);
    return known;
  }
  if (found->declaration != no_declaration) context_.program.references.add(span, found->declaration);
  if (!found->function && !found->type) return known;
  known.function = found->function;
  known.type = found->type;
  known.what = found->type || found->function->kind == Kind::def ? StaticType::What::thing : StaticType::What::function;
  if (found->function && found->function->kind == Kind::def)
    known.type = &context_.program.types.group(), known.is_bare_noun = true;
  return known;
}

StaticType ExpressionChecker::check_override(Unit& unit, NodeId node) {
  const Override parts = unit.ast.override_(node);
  StaticType base = check(unit, parts.base);
  Owner owner;
  if (base.is_thing()) {
    owner.type = base.type;
    owner.def = base.function;
  } else {
    owner.is_unknown = true;
    if (base.what != StaticType::What::nothing)
      errors::not_a_thing(context_, unit.ast.span(parts.base), base.what == StaticType::What::module);
  }
  const bool is_block = unit.ast.kind(parts.block) == Kind::block;
  if (is_block) items_.check_block(unit, parts.block, owner);
  if (is_block && base.is_bare_noun && !base.function && is_simple_block(unit, parts.block, *base.type))
    unit.ast[node].extra = static_cast<std::uint16_t>(context_.program.types.index(*base.type) + 1);
  base.is_bare_noun = false;
  return base;
}

void ExpressionChecker::check_comprehension(Unit& unit, NodeId node) {
  const Comprehension parts = unit.ast.comprehension(node);
  const bool has_frames = has_closure(unit.ast, node);
  std::vector<NodeId> framed;
  std::size_t scopes = 0;
  for (const NodeId clause : parts.clauses) {
    if (unit.ast.kind(clause) == Kind::filter) {
      check(unit, unit.ast.operand(clause));
      continue;
    }
    if (unit.ast.kind(clause) != Kind::clause) continue;
    check(unit, unit.ast.for_item(clause).head);
    if (has_frames) {
      scopes_.begin_activation();
      framed.push_back(clause);
    }
    scopes_.open(&unit, no_node, {});
    ++scopes;
    declare_loop_names(context_, scopes_, unit, clause);
  }
  check(unit, parts.element);
  for (; scopes > 0; --scopes) scopes_.close();
  for (; !framed.empty(); framed.pop_back()) end_loop_frame(context_, scopes_, unit, framed.back());
}

void declare_loop_names(CheckContext& context, Scopes& scopes, Unit& unit, NodeId loop) {
  const ForItem parts = unit.ast.for_item(loop);
  for (const NodeId name : {parts.index_name, parts.value_name}) {
    if (name == no_node) continue;
    Binding& binding = scopes.declare(unit, name, Meaning::value);
    binding.declaration =
        context.program.references.declare({Declaration::What::local, binding.name, binding.span, &unit, loop});
  }
}

} // namespace rt::lang
