#include "lang/check/items.hpp"

#include "lang/builtins/builtins.hpp"
#include "lang/check/calls.hpp"
#include "lang/check/errors/name_errors.hpp"
#include "lang/check/errors/statement_errors.hpp"
#include "lang/check/imports.hpp"
#include "lang/check/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace rt::lang {

namespace {

bool is_operand(const Ast& ast, NodeId node) {
  const Kind kind = ast.kind(node);
  return kind == Kind::number || kind == Kind::name || kind == Kind::unary || kind == Kind::binary;
}

// `at: 1, 2, 3`
void report_split_vectors(CheckContext& context, const Ast& ast, NodeId block) {
  const NodeList items = ast.children(block);
  for (std::size_t i = 0; i + 1 < items.size(); ++i) {
    if (ast.kind(items[i]) != Kind::property || !is_operand(ast, ast.named(items[i]).value)) continue;
    Span whole = ast.span(ast.named(items[i]).value);
    std::string numbers(context.text(whole));
    bool has_number = false;
    for (std::size_t k = i + 1; k < items.size() && k <= i + 2 && is_operand(ast, items[k]); ++k) {
      const Span longer{whole.file, whole.begin, ast[items[k]].end};
      if (context.text(longer).find('\n') != std::string_view::npos) break;
      whole = longer;
      numbers += fmt::format(", {}", context.text(ast.span(items[k])));
      has_number |= ast.kind(items[k]) == Kind::number;
    }
    if (has_number) errors::split_vector(context.report, whole, context.name(ast.named(items[i]).symbol), numbers);
  }
}

bool is_print(const Ast& ast, NodeId node) {
  if (ast.kind(node) != Kind::call) return false;
  const NodeId callee = ast.call(node).callee;
  return ast.kind(callee) == Kind::name && resolution(ast[callee]) == Resolution::builtin &&
         all_builtins()[ast.slot(callee)]->name == "print";
}

} // namespace

void ItemChecker::check_all(Unit& unit, NodeId block) {
  for (const NodeId item : unit.ast.children(block)) hoist(unit, item);
  report_split_vectors(context_, unit.ast, block);
  for (const NodeId item : unit.ast.children(block)) check(unit, item);
}

void ItemChecker::check_block(Unit& unit, NodeId block, const Owner& owner) {
  scopes_.open(&unit, block, owner);
  check_all(unit, block);
  check_duplicates(context_, unit, block, owner);
  scopes_.close();
}

void ItemChecker::check_value_block(Unit& unit, NodeId block, std::string_view what) {
  scopes_.open(&unit, block, {});
  const NodeList items = unit.ast.children(block);
  for (const NodeId item : items) hoist(unit, item);
  const auto complain = [&](NodeId node, std::string_view why) {
    errors::not_one_value(context_.report, unit.ast.span(node), what, why);
  };
  for (const NodeId item : items) {
    const Kind kind = unit.ast.kind(item);
    const bool is_last = item == items.back();
    const bool is_statement = kind == Kind::property || kind == Kind::for_ || kind == Kind::param;
    const bool binds = is_declaration(kind) && !is_statement;
    if (binds || is_statement || kind == Kind::expect)
      check(unit, item);
    else
      check_value(unit, item);
    if (kind == Kind::error || kind == Kind::expect) continue;
    if (is_statement)
      complain(item, "this is not a value");
    else if (!is_last && !binds && !is_print(unit.ast, item))
      complain(item, "only the last line gives the value");
    else if (is_last && binds)
      complain(item, "the value is missing after this");
  }
  if (items.empty()) complain(block, "there is no value in it");
  scopes_.close();
}

// Names of defs and fns are visible throughout their block, so they are declared before anything else is read.
void ItemChecker::hoist(Unit& unit, NodeId item) {
  const Kind kind = unit.ast.kind(item);
  if (kind == Kind::def || kind == Kind::fn)
    hoist_function(unit, item);
  else if (kind == Kind::include)
    hoist_include(unit, item);
}

void ItemChecker::hoist_function(Unit& unit, NodeId item) {
  constexpr std::size_t top_level_activations = 2; // the library's, and the file's
  const NodeId name = unit.ast.function(item).name;
  const auto index = static_cast<std::uint32_t>(context_.program.functions.size());
  FunctionInfo& info = add_function(context_, unit, item);
  const bool is_def = info.kind == Kind::def;
  info.is_at_top_level = scopes_.activations() == top_level_activations;
  info.module = context_.module;
  info.declaration = declare(unit, name, item, is_def ? Declaration::What::def : Declaration::What::fn);
  References& references = context_.program.references;
  references.begin(info.declaration);
  for (FunctionInfo::Parameter& p : info.parameters)
    p.declaration = declare(unit, p.node, item, Declaration::What::parameter);
  references.end(info.declaration);
  Binding& binding = scopes_.declare(unit, name, Meaning::function);
  binding.slot = index;
  binding.declaration = info.declaration;
  binding.known.what = is_def ? StaticType::What::thing : StaticType::What::function;
  binding.known.function = &info;
  binding.known.is_bare_noun = is_def;
  if (is_def) binding.known.type = &context_.program.types.group();
  references.set_known(info.declaration, binding.known);
}

void ItemChecker::hoist_include(Unit& unit, NodeId item) {
  Unit* included = read_included(context_, unit, item);
  if (!included) return names_.set_names_missing();
  context_.open_files.push_back(context_.program.sources.file(included->ast.file).path);
  for (const NodeId inner : included->ast.children(included->ast.root)) hoist(*included, inner);
  context_.open_files.pop_back();
}

void ItemChecker::check(Unit& unit, NodeId item) {
  const Ast& ast = unit.ast;
  switch (ast.kind(item)) {
  case Kind::error:
    return declare_error(unit, item);
  case Kind::include:
    if (Unit* included = unit.included(item)) {
      for (const NodeId inner : included->ast.children(included->ast.root)) check(*included, inner);
    }
    return;
  case Kind::use:
    return check_use(unit, item);
  case Kind::param:
    return check_param(unit, item);
  case Kind::def:
  case Kind::fn:
    return check_function(unit, context_.program.functions[ast.function_index(item)]);
  case Kind::for_:
    return check_for(unit, item);
  case Kind::if_:
    return check_if(unit, item);
  case Kind::bind:
    return check_bind(unit, item);
  case Kind::property:
    check_property_value(unit, item);
    return check_property(context_, unit, item, scopes_.owner());
  case Kind::expect:
    return check_expect(unit, item);
  case Kind::repeat:
    return check_repeat(unit, ast.repeat(item));
  default:
    check_value(unit, item);
  }
}

void ItemChecker::check_property_value(Unit& unit, NodeId item) {
  const NodeType* const type = scopes_.owner().type;
  const auto found = type ? type->find(unit.ast.named(item).symbol) : std::nullopt;
  if (found) names_.set_choices(type->properties[*found].choices);
  check_value(unit, unit.ast.named(item).value);
  names_.set_choices({});
}

DeclarationId ItemChecker::declare(const Unit& unit, NodeId name, NodeId item, Declaration::What what) {
  return context_.program.references.declare({what, unit.ast.symbol(name), unit.ast.span(name), &unit, item,
                                              scopes_.is_at_top_level() && what != Declaration::What::parameter});
}

// The name that an erroneous line was to declare is known, so that its uses are not reported as well.
void ItemChecker::declare_error(Unit& unit, NodeId item) {
  const Symbol symbol = unit.ast.error_name(item);
  Span span = unit.ast.span(item);
  if (context_.program.references.is_kept()) names_.refer_to_names(span);
  if (symbol == no_symbol) return;
  Binding& binding = scopes_.declare(symbol, span, Meaning::error);
  const std::size_t at = context_.text(span).find(context_.name(symbol));
  if (at == std::string_view::npos) return;
  span.begin += static_cast<std::uint32_t>(at);
  span.end = span.begin + static_cast<std::uint32_t>(context_.name(symbol).size());
  binding.declaration = context_.program.references.declare({Declaration::What::unknown, symbol, span, &unit, item});
}

// What is known about the model applies to all; what is wrong with it is reported for each.
void ItemChecker::check_repeat(Unit& unit, const Repeat& repeat) {
  const std::pair<const Unit*, NodeId> model{&unit, repeat.model};
  if (repeat.is_first) {
    const std::size_t before = context_.report.error_count();
    check(unit, repeat.model);
    if (context_.report.error_count() != before) wrong_models_.push_back(model);
  }
  if (std::ranges::find(wrong_models_, model) == wrong_models_.end()) return;
  RepeatSpans spans(context_.report, context_.program.sources, unit.ast.model_span(repeat));
  for (std::uint32_t i = 0; i < repeat.count && !context_.report.is_full(); ++i) {
    spans.stand_for(unit.ast.item_span(repeat, i));
    check(unit, repeat.model);
  }
}

void ItemChecker::check_use(Unit& unit, NodeId item) {
  const NodeId name = unit.ast.use_item(item).name;
  const ModuleInfo* module = read_module(context_, unit, item);
  Binding& binding = scopes_.declare(unit, name, module ? Meaning::module : Meaning::error);
  binding.declaration = declare(unit, name, item, module ? Declaration::What::module : Declaration::What::unknown);
  if (!module) return;
  unit.uses.emplace_back(item, module);
  binding.known.what = StaticType::What::module;
  binding.known.module = module;
  context_.program.references.set_known(binding.declaration, binding.known);
}

void ItemChecker::check_param(Unit& unit, NodeId item) {
  const ParamItem param = unit.ast.param_item(item);
  if (!scopes_.is_at_top_level()) errors::param_below_top_level(context_.report, unit.ast.span(param.name));
  const Symbol symbol = unit.ast.symbol(param.name);
  names_.set_being_bound({symbol});
  const DeclarationId declaration = declare(unit, param.name, item, Declaration::What::param);
  context_.program.references.begin(declaration);
  const StaticType known = check_value(unit, param.value);
  if (param.range != no_node) check_value(unit, param.range);
  context_.program.references.end(declaration);
  context_.program.references.set_known(declaration, known);
  names_.set_being_bound({});
  if (!context_.module) {
    for (Define& define : context_.program.defines) define.is_used |= define.name == symbol;
    context_.program.param_names.push_back(symbol);
  }
  scopes_.declare(unit, param.name, Meaning::value).declaration = declaration;
}

void ItemChecker::check_bind(Unit& unit, NodeId item) {
  const BindItem bind = unit.ast.bind_item(item);
  const NameResolver::BeingBound outer = names_.being_bound();
  names_.set_being_bound({unit.ast.symbol(bind.name), unit.ast.kind(bind.value) == Kind::lambda});
  const DeclarationId declaration = declare(unit, bind.name, item, Declaration::What::value);
  context_.program.references.begin(declaration);
  StaticType known = check_value(unit, bind.value);
  context_.program.references.end(declaration);
  names_.set_being_bound(outer);
  known.is_bare_noun = false;
  context_.program.references.set_known(declaration, known);
  Binding& binding = scopes_.declare(unit, bind.name, Meaning::value);
  binding.declaration = declaration;
  binding.known = known;
  const Owner& owner = scopes_.owner();
  binding.may_be_property = (owner.type && owner.type->find(binding.name)) ||
                            (owner.def && !owner.is_def_body && owner.def->find(binding.name));
}

void ItemChecker::check_function(Unit& unit, FunctionInfo& info) {
  context_.program.references.begin(info.declaration);
  scopes_.begin_activation();
  scopes_.open(&unit, no_node, {});
  declare_parameters(unit, info);
  const bool is_block = unit.ast.kind(info.body) == Kind::block;
  if (info.kind == Kind::def) {
    Owner owner;
    owner.type = &context_.program.types.group();
    owner.def = &info;
    owner.is_def_body = true;
    if (is_block) check_block(unit, info.body, owner);
  } else if (is_block) {
    check_value_block(unit, info.body, "a function");
  } else {
    check_value(unit, info.body);
  }
  scopes_.close();
  info.frame_size = scopes_.end_activation();
  context_.program.references.end(info.declaration);
}

void ItemChecker::declare_parameters(Unit& unit, FunctionInfo& info) {
  for (FunctionInfo::Parameter& parameter : info.parameters) {
    if (parameter.default_value != no_node) {
      names_.set_being_bound({parameter.name});
      check_value(unit, parameter.default_value);
      names_.set_being_bound({});
    }
    if (info.kind == Kind::lambda)
      parameter.declaration = declare(unit, parameter.node, info.node, Declaration::What::local);
    Binding& binding = scopes_.declare(unit, parameter.node, Meaning::value);
    binding.declaration = parameter.declaration;
    parameter.slot = binding.slot;
    if (info.kind == Kind::def && context_.program.types.group().find(parameter.name))
      errors::parameter_hides_property(context_, unit.ast.span(parameter.node), parameter.name);
  }
}

void ItemChecker::check_for(Unit& unit, NodeId item) {
  const ForItem loop = unit.ast.for_item(item);
  check_value(unit, loop.head);
  const bool has_frame = has_closure(unit.ast, loop.body);
  if (has_frame) scopes_.begin_activation();
  const Owner owner = scopes_.owner();
  scopes_.open(&unit, no_node, owner);
  declare_loop_names(context_, scopes_, unit, item);
  if (unit.ast.kind(loop.body) == Kind::block) check_block(unit, loop.body, owner);
  scopes_.close();
  if (has_frame) end_loop_frame(context_, scopes_, unit, item);
}

// It is evaluated once the scene is complete, so it cannot be in code that may run any number of times, or never.
void ItemChecker::check_expect(Unit& unit, NodeId item) {
  const ExpectItem expect = unit.ast.expect_item(item);
  if (scopes_.owner().type != &context_.program.types.scene())
    errors::expect_below_top_level(context_.report, unit.ast.span(item));
  names_.set_in_expect(true);
  const bool asks_ray = expect.claim == Claim::hits || expect.claim == Claim::misses;
  if (asks_ray && !is_ray_question(context_, unit, expect.subject))
    errors::claim_of_no_ray(context_.report, unit.ast.span(expect.subject), expect.claim);
  for (const NodeId part : {expect.subject, expect.other, expect.parameter, expect.tolerance}) {
    if (part != no_node) check_value(unit, part);
  }
  names_.set_in_expect(false);
}

void ItemChecker::check_if(Unit& unit, NodeId item) {
  const IfNode branch = unit.ast.if_node(item);
  const Owner owner = scopes_.owner();
  check_value(unit, branch.condition);
  if (unit.ast.kind(branch.then) == Kind::block) check_block(unit, branch.then, owner);
  if (branch.otherwise == no_node) return;
  if (unit.ast.kind(branch.otherwise) == Kind::if_)
    check_if(unit, branch.otherwise);
  else if (unit.ast.kind(branch.otherwise) == Kind::block)
    check_block(unit, branch.otherwise, owner);
}

} // namespace rt::lang
