#include "lang/check/checker.hpp"
#include "lang/check/dialects.hpp"
#include "lang/text/suggest.hpp"
#include "lang/values/thing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt::lang {

StaticType Checker::check_expression(Unit& unit, NodeId node) {
  Ast& ast = unit.ast;
  switch (ast.kind(node)) {
  case Kind::name:
    return resolve(unit, node);
  case Kind::list:
    for (const NodeId child : ast.children(node)) check_expression(unit, child);
    return {};
  case Kind::record:
    check_record(unit, node);
    return {};
  case Kind::comprehension:
    check_comprehension(unit, node);
    return {};
  case Kind::lambda:
    return check_lambda(unit, node);
  case Kind::call:
    return check_call(unit, node);
  case Kind::index: {
    const Index index = ast.index(node);
    check_expression(unit, index.base);
    check_expression(unit, index.index);
    return {};
  }
  case Kind::member:
    return check_member(unit, node, false);
  case Kind::override_:
    return check_override(unit, node);
  case Kind::unary:
    check_expression(unit, ast.operand(node));
    return {};
  case Kind::binary:
    return check_binary(unit, node);
  case Kind::range: {
    const Range range = ast.range(node);
    check_expression(unit, range.from);
    check_expression(unit, range.to);
    if (range.step != no_node) check_expression(unit, range.step);
    return {};
  }
  case Kind::if_:
    return check_if_value(unit, node);
  case Kind::block:
    check_value_block(unit, node, "this block");
    return {};
  default:
    return {};
  }
}

StaticType Checker::check_binary(Unit& unit, NodeId node) {
  const StaticType left = check_expression(unit, unit.ast.left(node));
  check_expression(unit, unit.ast.right(node));
  StaticType known;
  if (!left.is_thing() || !left.type->is_shape()) return known;
  using Operation = scene::Combination::Operation;
  const Op op = unit.ast.op(node);
  if (op != Op::unite && op != Op::intersect && op != Op::subtract) return known;
  known.what = StaticType::What::thing;
  known.type = &program_.types.combination(op == Op::unite       ? Operation::unite
                                           : op == Op::intersect ? Operation::intersect
                                                                 : Operation::subtract);
  return known;
}

StaticType Checker::check_if_value(Unit& unit, NodeId node) {
  const IfNode branch = unit.ast.if_node(node);
  check_expression(unit, branch.condition);
  const auto check_branch = [&](NodeId body) {
    if (unit.ast.kind(body) == Kind::block)
      check_value_block(unit, body, "a branch of an `if` that is a value");
    else
      check_expression(unit, body);
  };
  check_branch(branch.then);
  if (branch.otherwise != no_node) {
    check_branch(branch.otherwise);
  } else if (Diagnostic* d = report_.error("E0313", unit.ast.span(node))) {
    d->message = "an `if` that is a value needs an `else`";
    d->label = "no value where the condition is false";
  }
  return {};
}

// Bindings, then one expression.
void Checker::check_value_block(Unit& unit, NodeId block, std::string_view what) {
  open_scope(&unit, block, {});
  hoist(unit, block);
  const NodeList items = unit.ast.children(block);
  const auto complain = [&](Span span, std::string label) {
    if (Diagnostic* d = report_.error("E0314", span)) {
      d->message = fmt::format("{} holds names and then one value", what);
      d->label = std::move(label);
    }
  };
  for (std::size_t i = 0; i < items.size(); ++i) {
    const NodeId item = items[i];
    const Kind kind = unit.ast.kind(item);
    const bool is_last = i + 1 == items.size();
    const bool is_declaration = kind == Kind::bind || kind == Kind::def || kind == Kind::fn || kind == Kind::error ||
                                kind == Kind::use || kind == Kind::include;
    const bool is_statement = kind == Kind::property || kind == Kind::for_ || kind == Kind::param;
    if (is_declaration || is_statement || kind == Kind::expect)
      check_item(unit, item);
    else
      check_expression(unit, item);
    if (kind == Kind::error || kind == Kind::expect) continue;
    if (is_statement)
      complain(unit.ast.span(item), "this is not a value");
    else if (!is_last && !is_declaration)
      complain(unit.ast.span(item), "only the last line gives the value");
    else if (is_last && is_declaration)
      complain(unit.ast.span(item), "the value is missing after this");
  }
  if (items.empty()) complain(unit.ast.span(block), "there is no value in it");
  close_scope();
}

StaticType Checker::check_lambda(Unit& unit, NodeId node) {
  const Function function = unit.ast.function(node);
  const auto index = static_cast<std::uint32_t>(program_.functions.size());
  FunctionInfo& info = program_.functions.emplace_back();
  info.unit = &unit;
  info.node = node;
  info.kind = Kind::lambda;
  info.body = function.body;
  for (const NodeId item : function.parameters) {
    if (unit.ast.kind(item) != Kind::parameter) continue;
    const Parameter parameter = unit.ast.parameter(item);
    info.parameters.push_back({unit.ast.symbol(parameter.name), 0, parameter.default_value, parameter.name});
  }
  set_function_index(unit.ast[node], index);
  const Symbol outer = being_bound_;
  check_function_body(unit, node);
  being_bound_ = outer;
  StaticType known;
  known.what = StaticType::What::function;
  known.function = &info;
  return known;
}

// A name is looked up among the questions and the chain methods too, unless the scene has bound it.
StaticType Checker::check_callee(Unit& unit, NodeId callee) {
  Ast& ast = unit.ast;
  if (ast.kind(callee) == Kind::member) return check_member(unit, callee, true);
  if (ast.kind(callee) != Kind::name || find(ast.symbol(callee))) return check_expression(unit, callee);
  const std::string_view word = name(ast.symbol(callee));
  StaticType known;
  if (const auto question = is_in_expect_ ? find_question(word) : std::nullopt) {
    ast.set_slot(callee, static_cast<std::uint32_t>(*question), pack(Resolution::question, 0));
    known.what = StaticType::What::builtin, known.builtin = &questions()[*question];
    return known;
  }
  if (!find_chain_method(word)) return check_expression(unit, callee);
  ast.set_slot(callee, 0, pack(Resolution::none, 0));
  if (Diagnostic* d = report_.error("E0210", ast.span(callee))) {
    d->message = fmt::format("`{}` is written behind a thing", word);
    d->label = fmt::format("write `thing.{}(…)`", word);
  }
  return known;
}

bool Checker::is_query(const Unit& unit, NodeId node) const {
  if (unit.ast.kind(node) == Kind::error) return true; // reported
  if (unit.ast.kind(node) != Kind::call) return false;
  const NodeId callee = unit.ast.call(node).callee;
  if (unit.ast.kind(callee) != Kind::name) return false;
  const std::string_view word = name(unit.ast.symbol(callee));
  return word == "pixel" || word == "image_point" || word == "ray";
}

StaticType Checker::check_call(Unit& unit, NodeId node) {
  Ast& ast = unit.ast;
  const Call call = ast.call(node);
  const StaticType callee = check_callee(unit, call.callee);
  for (const NodeId argument : call.arguments) {
    if (ast.kind(argument) == Kind::argument)
      check_expression(unit, ast.named(argument).value);
    else
      check_expression(unit, argument);
  }
  if (callee.what == StaticType::What::function && callee.function)
    check_function_call(unit, node, *callee.function);
  else if (callee.what == StaticType::What::builtin)
    check_signature_call(unit, node, callee.builtin->name, callee.builtin->signature);
  else if (callee.is_thing() && callee.is_bare_noun)
    check_thing_call(unit, node, callee);
  if (report_.wants_remarks()) {
    const ChainMethod* method =
        ast.kind(call.callee) == Kind::member ? find_chain_method(name(ast.member(call.callee).symbol)) : nullptr;
    if (method && callee.what != StaticType::What::function)
      check_angle_arguments(unit, node, method->signature, method->name == "rotate");
    else if (callee.what == StaticType::What::builtin)
      check_angle_arguments(unit, node, callee.builtin->signature, false);
  }
  // A chain method gives the thing it was called on, with one step more.
  if (ast.kind(call.callee) == Kind::member && callee.is_thing()) return callee;
  return {};
}

void Checker::check_thing_call(Unit& unit, NodeId node, const StaticType& callee) {
  const Call call = unit.ast.call(node);
  Diagnostic* d = report_.error("E0209", unit.ast.span(node));
  if (!d) return;
  const std::string_view type = callee.function ? name(callee.function->name) : callee.type->name;
  std::string properties;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const NodeId argument = call.arguments[i];
    if (i > 0) properties += ", ";
    if (unit.ast.kind(argument) == Kind::argument) {
      properties += program_.sources.text(unit.ast.span(argument));
    } else if (callee.function && i < callee.function->parameters.size()) {
      properties += fmt::format("{}: {}", name(callee.function->parameters[i].name),
                                program_.sources.text(unit.ast.span(argument)));
    } else if (!callee.function && i < callee.type->properties.size()) {
      properties +=
          fmt::format("{}: {}", callee.type->properties[i].name, program_.sources.text(unit.ast.span(argument)));
    }
  }
  d->message = fmt::format("`{}` is a thing, and things take braces", type);
  d->label =
      properties.empty() ? fmt::format("write `{} {{}}`", type) : fmt::format("write `{} {{ {} }}`", type, properties);
}

void Checker::check_function_call(Unit& unit, NodeId node, const FunctionInfo& function) {
  const std::string what = function.name == no_symbol ? "this function" : fmt::format("`{}`", name(function.name));
  const auto parameters = [&] {
    std::string text;
    for (const FunctionInfo::Parameter& p : function.parameters)
      text += fmt::format("{}{}", text.empty() ? "" : ", ", name(p.name));
    return text;
  };
  const auto complain = [&](Span span, std::string message, std::string label) {
    Diagnostic* d = report_.error("E0208", span);
    if (!d) return;
    d->message = std::move(message);
    d->label = std::move(label);
    d->notes.push_back({function.unit->ast.span(function.node), fmt::format("it takes ({})", parameters())});
  };
  std::vector<bool> is_given(function.parameters.size());
  std::size_t positional = 0;
  for (const NodeId argument : unit.ast.call(node).arguments) {
    if (unit.ast.kind(argument) != Kind::argument) {
      if (positional >= function.parameters.size())
        return complain(unit.ast.span(argument),
                        fmt::format("{} takes {}", what, count_of_arguments(function.parameters.size())),
                        "one too many");
      is_given[positional++] = true;
      continue;
    }
    const Symbol symbol = unit.ast.named(argument).symbol;
    const Span span = unit.ast.named_span(argument, program_.symbols);
    const auto i = function.find(symbol);
    if (!i) {
      std::vector<std::string_view> names;
      for (const FunctionInfo::Parameter& p : function.parameters) names.push_back(name(p.name));
      const auto guess = nearest(name(symbol), names);
      return complain(span, fmt::format("{} has no parameter `{}`", what, name(symbol)),
                      guess ? fmt::format("did you mean `{}`?", *guess) : "");
    }
    if (is_given[*i]) return complain(span, fmt::format("`{}` is given twice", name(symbol)), "");
    is_given[*i] = true;
  }
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    if (!is_given[i] && function.parameters[i].default_value == no_node)
      return complain(unit.ast.span(node),
                      fmt::format("{} needs a value for `{}`", what, name(function.parameters[i].name)), "");
  }
}

void Checker::check_signature_call(Unit& unit, NodeId node, std::string_view function, const Signature& signature) {
  const auto complain = [&](Span span, std::string message, std::string label) {
    Diagnostic* d = report_.error("E0208", span);
    if (!d) return;
    d->message = std::move(message);
    d->label = std::move(label);
    d->notes.push_back({std::nullopt, fmt::format("{}({})", function, signature.text())});
  };
  std::vector<bool> is_given(signature.size());
  std::size_t positional = 0;
  for (const NodeId argument : unit.ast.call(node).arguments) {
    if (unit.ast.kind(argument) != Kind::argument) {
      if (positional >= signature.size() && !signature.has_rest())
        return complain(unit.ast.span(argument),
                        fmt::format("`{}` takes at most {}", function, count_of_arguments(signature.size())),
                        "one too many");
      is_given[std::min(positional++, signature.size() - 1)] = true;
      continue;
    }
    const std::string_view word = name(unit.ast.named(argument).symbol);
    const Span span = unit.ast.named_span(argument, program_.symbols);
    const auto found = std::ranges::find(signature, word, &SignatureParameter::name);
    if (found == signature.end()) {
      std::vector<std::string_view> names;
      for (const SignatureParameter& p : signature) names.push_back(p.name);
      const auto guess = nearest(word, names);
      return complain(span, fmt::format("`{}` has no parameter `{}`", function, word),
                      guess ? fmt::format("did you mean `{}`?", *guess) : "");
    }
    const auto i = static_cast<std::size_t>(found - signature.begin());
    if (is_given[i]) return complain(span, fmt::format("`{}` is given twice", word), "");
    is_given[i] = true;
  }
  for (std::size_t i = 0; i < signature.size(); ++i) {
    if (!is_given[i] && !signature[i].is_optional)
      return complain(unit.ast.span(node), fmt::format("`{}` needs a value for `{}`", function, signature[i].name), "");
  }
}

StaticType Checker::check_member(Unit& unit, NodeId node, bool is_called) {
  const Member member = unit.ast.member(node);
  reads_part_ = !is_called && unit.ast.kind(member.base) == Kind::name;
  const StaticType base = check_expression(unit, member.base);
  const std::string_view word = name(member.symbol);
  const Span span = unit.ast.member_span(node, program_.symbols);
  StaticType known;
  if (base.what == StaticType::What::module) {
    const ModuleInfo::Export* found = base.module->find(member.symbol);
    if (!found) {
      if (Diagnostic* d = report_.error("E0212", span)) {
        std::vector<std::string_view> names;
        for (const ModuleInfo::Export& e : base.module->exports) names.push_back(name(e.name));
        const auto guess = nearest(word, names);
        d->message = fmt::format("the file has no name `{}`", word);
        d->label = guess ? fmt::format("did you mean `{}`?", *guess) : "";
      }
      return known;
    }
    if (!found->function && !found->type) return known;
    known.function = found->function;
    known.type = found->type;
    known.what =
        found->type || found->function->kind == Kind::def ? StaticType::What::thing : StaticType::What::function;
    if (found->function && found->function->kind == Kind::def)
      known.type = &program_.types.group(), known.is_bare_noun = true;
    return known;
  }
  if (!base.is_thing() || !is_called) return known;
  if (find_chain_method(word)) {
    known = base;
    known.is_bare_noun = false;
    return known;
  }
  if (Diagnostic* d = report_.error("E0212", span)) {
    std::vector<std::string_view> names;
    for (const ChainMethod& method : chain_methods()) names.push_back(method.name);
    const auto guess = nearest(word, names);
    const std::string other = dialect_name(word);
    d->message = fmt::format("a thing has no `.{}(…)`", word);
    d->label = !other.empty() ? other : guess ? fmt::format("did you mean `{}`?", *guess) : "";
  }
  return known;
}

StaticType Checker::check_override(Unit& unit, NodeId node) {
  const Override parts = unit.ast.override_(node);
  StaticType base = check_expression(unit, parts.base);
  Owner owner;
  if (base.is_thing()) {
    owner.type = base.type;
    owner.def = base.function;
  } else if (base.what == StaticType::What::nothing) {
    owner.is_unknown = true;
  } else if (Diagnostic* d = report_.error("E0210", unit.ast.span(parts.base))) {
    const std::string_view word = program_.sources.text(unit.ast.span(parts.base));
    d->message = base.what == StaticType::What::module ? fmt::format("`{}` is a file, not a thing", word)
                                                       : fmt::format("`{}` is a function, not a thing", word);
    d->label = base.what == StaticType::What::module ? "write the name of a thing in it, after a dot"
                                                     : "a function takes its arguments in ( )";
    owner.is_unknown = true;
  }
  const bool is_block = unit.ast.kind(parts.block) == Kind::block;
  if (is_block) check_block(unit, parts.block, owner);
  if (is_block && base.is_bare_noun && !base.function && is_simple(unit, parts.block, *base.type))
    unit.ast[node].extra = static_cast<std::uint16_t>(program_.types.index(*base.type) + 1);
  base.is_bare_noun = false;
  return base;
}

// Nothing but properties, each once and of one form: evaluated without further ado.
bool Checker::is_simple(const Unit& unit, NodeId block, const NodeType& type) const {
  if (type.is_composite() || unit.ast.children(block).size() > PropertyList::most) return false;
  int form = 0;
  std::uint64_t seen = 0;
  for (const NodeId item : unit.ast.children(block)) {
    const Node& node = unit.ast[item];
    if (node.kind != Kind::property || node.extra == 0 || node.extra > 64) return false;
    const std::uint64_t bit = std::uint64_t{1} << (node.extra - 1);
    const int own_form = type.properties[static_cast<std::size_t>(node.extra - 1)].form;
    if ((seen & bit) != 0 || (form != 0 && own_form != 0 && form != own_form)) return false;
    seen |= bit;
    if (own_form != 0) form = own_form;
  }
  return true;
}

void Checker::check_comprehension(Unit& unit, NodeId node) {
  const Comprehension parts = unit.ast.comprehension(node);
  const bool has_frames = has_closure(unit, node);
  std::vector<NodeId> framed;
  std::size_t scopes = 0;
  for (const NodeId clause : parts.clauses) {
    if (unit.ast.kind(clause) == Kind::filter) {
      check_expression(unit, unit.ast.operand(clause));
      continue;
    }
    if (unit.ast.kind(clause) != Kind::clause) continue;
    const ForItem loop = unit.ast.for_item(clause);
    check_expression(unit, loop.head);
    if (has_frames) {
      begin_activation();
      framed.push_back(clause);
    }
    open_scope(&unit, no_node, {});
    ++scopes;
    if (loop.index_name != no_node) declare(unit, loop.index_name, Binding::What::value);
    declare(unit, loop.value_name, Binding::What::value);
  }
  check_expression(unit, parts.element);
  for (; scopes > 0; --scopes) close_scope();
  for (; !framed.empty(); framed.pop_back()) set_loop_frame(unit, framed.back());
}

void Checker::check_record(Unit& unit, NodeId node) {
  const NodeList items = unit.ast.children(node);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (unit.ast.kind(items[i]) != Kind::property) continue;
    const Named field = unit.ast.named(items[i]);
    check_expression(unit, field.value);
    for (std::size_t k = 0; k < i; ++k) {
      if (unit.ast.kind(items[k]) != Kind::property || unit.ast.named(items[k]).symbol != field.symbol) continue;
      if (Diagnostic* d = report_.error("E0205", unit.ast.named_span(items[i], program_.symbols))) {
        d->message = fmt::format("`{}` is written twice", name(field.symbol));
        d->notes.push_back({unit.ast.named_span(items[k], program_.symbols), "first here"});
      }
    }
  }
}

// The nodes of an expression or block stand one after the other, the root last; the first is found along the way.
bool Checker::has_closure(const Unit& unit, NodeId node) const {
  const Ast& ast = unit.ast;
  const std::uint32_t begin = ast[node].begin;
  for (auto i = static_cast<std::uint32_t>(node); i-- > 0;) {
    const Node& inner = ast.nodes[i];
    if (inner.begin < begin) return false;
    if (inner.kind == Kind::lambda || inner.kind == Kind::def || inner.kind == Kind::fn ||
        inner.kind == Kind::include || inner.kind == Kind::expect)
      return true;
  }
  return false;
}

} // namespace rt::lang
