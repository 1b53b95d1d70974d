#include "lang/syntax/ast.hpp"
#include "lang/text/literals.hpp"

#include <fmt/format.h>

#include <iterator>

namespace rt::lang {

namespace {

std::string_view word(Kind kind) {
  switch (kind) {
  case Kind::error:
    return "error";
  case Kind::include:
    return "include";
  case Kind::use:
    return "use";
  case Kind::param:
    return "param";
  case Kind::def:
    return "def";
  case Kind::fn:
    return "fn";
  case Kind::for_:
    return "for";
  case Kind::if_:
    return "if";
  case Kind::bind:
    return "bind";
  case Kind::property:
    return "property";
  case Kind::expect:
    return "expect";
  case Kind::number:
    return "number";
  case Kind::string:
    return "string";
  case Kind::color:
    return "color";
  case Kind::boolean:
    return "boolean";
  case Kind::none:
    return "none";
  case Kind::name:
    return "name";
  case Kind::previous:
    return "previous";
  case Kind::numbers:
    return "numbers";
  case Kind::list:
    return "list";
  case Kind::record:
    return "record";
  case Kind::comprehension:
    return "comprehension";
  case Kind::lambda:
    return "lambda";
  case Kind::call:
    return "call";
  case Kind::index:
    return "index";
  case Kind::member:
    return "member";
  case Kind::override_:
    return "override";
  case Kind::unary:
    return "unary";
  case Kind::binary:
    return "binary";
  case Kind::range:
    return "range";
  case Kind::block:
    return "block";
  case Kind::parameter:
    return "parameter";
  case Kind::argument:
    return "argument";
  case Kind::filter:
    return "filter";
  case Kind::clause:
    return "clause";
  case Kind::repeat:
    return "repeat";
  }
  return "";
}

class Dumper {
public:
  Dumper(const Ast& ast, const SourceMap& sources, const SymbolTable& symbols)
      : ast_(ast), sources_(sources), symbols_(symbols) {}

  std::string take() && { return std::move(out_); }

  void node(NodeId id, int depth, std::string_view role = "") {
    if (id == no_node) return;
    const Position at = sources_.position(ast_.file, ast_[id].begin);
    fmt::format_to(std::back_inserter(out_), "{:{}}{}:{} {}{}{}{}\n", "", depth * 2, at.line, at.column, role,
                   role.empty() ? "" : ": ", word(ast_.kind(id)), detail(id));
    parts(id, depth + 1);
  }

private:
  std::string detail(NodeId id) const {
    switch (ast_.kind(id)) {
    case Kind::include:
    case Kind::use:
    case Kind::string:
      return ' ' + write_string(ast_.text(id));
    case Kind::number:
      return fmt::format(" {}", ast_.number(id));
    case Kind::color:
      return fmt::format(" #{:06x}", ast_.color(id));
    case Kind::boolean:
      return ast_.boolean(id) ? " true" : " false";
    case Kind::numbers:
      return fmt::format(" [{}]", fmt::join(ast_.numbers(id), ", "));
    case Kind::name:
      return fmt::format(" {}", symbols_.name(ast_.symbol(id)));
    case Kind::property:
    case Kind::argument:
      return fmt::format(" {}", symbols_.name(ast_.named(id).symbol));
    case Kind::member:
      return fmt::format(" {}", symbols_.name(ast_.member(id).symbol));
    case Kind::unary:
    case Kind::binary:
      return fmt::format(" {}", spelling(ast_.op(id)));
    case Kind::expect:
      return ast_.expect_item(id).claim == Claim::holds ? "" : fmt::format(" {}", spelling(ast_.expect_item(id).claim));
    case Kind::range:
      return ast_.range(id).excludes_end ? " ..<" : " ..";
    case Kind::repeat:
      return fmt::format(" {} more like it", ast_.repeat(id).count);
    default:
      return "";
    }
  }

  void list(NodeList ids, int depth) {
    for (const NodeId id : ids) node(id, depth);
  }

  void parts(NodeId id, int depth) {
    switch (ast_.kind(id)) {
    case Kind::block:
    case Kind::list:
    case Kind::record:
      return list(ast_.children(id), depth);
    case Kind::use:
      return node(ast_.use_item(id).name, depth, "as");
    case Kind::param:
      return param(ast_.param_item(id), depth);
    case Kind::def:
    case Kind::fn:
    case Kind::lambda:
      return function(ast_.function(id), depth);
    case Kind::for_:
    case Kind::clause:
      return loop(ast_.for_item(id), depth);
    case Kind::if_:
      return choice(ast_.if_node(id), depth);
    case Kind::bind:
      return node(ast_.bind_item(id).name, depth), node(ast_.bind_item(id).value, depth);
    case Kind::expect:
      return expectation(ast_.expect_item(id), depth);
    case Kind::property:
    case Kind::argument:
      return node(ast_.named(id).value, depth);
    case Kind::comprehension:
      return node(ast_.comprehension(id).element, depth), list(ast_.comprehension(id).clauses, depth);
    case Kind::call:
      return node(ast_.call(id).callee, depth, "callee"), list(ast_.call(id).arguments, depth);
    case Kind::index:
      return node(ast_.index(id).base, depth), node(ast_.index(id).index, depth, "at");
    case Kind::member:
      return node(ast_.member(id).base, depth);
    case Kind::override_:
      return node(ast_.override_(id).base, depth), node(ast_.override_(id).block, depth);
    case Kind::unary:
    case Kind::filter:
      return node(ast_.operand(id), depth);
    case Kind::binary:
      return node(ast_.left(id), depth), node(ast_.right(id), depth);
    case Kind::range:
      return range(ast_.range(id), depth);
    case Kind::parameter:
      return node(ast_.parameter(id).name, depth), node(ast_.parameter(id).default_value, depth, "default");
    default:
      return;
    }
  }

  void param(const ParamItem& item, int depth) {
    node(item.name, depth);
    node(item.value, depth);
    node(item.range, depth, "in");
  }

  void expectation(const ExpectItem& item, int depth) {
    node(item.subject, depth);
    node(item.other, depth);
    node(item.parameter, depth, "at t");
    node(item.tolerance, depth, "within");
  }

  void function(const Function& function, int depth) {
    node(function.name, depth);
    list(function.parameters, depth);
    node(function.body, depth, "body");
  }

  void loop(const ForItem& loop, int depth) {
    node(loop.index_name, depth, "index");
    node(loop.value_name, depth, "value");
    node(loop.head, depth, "in");
    node(loop.body, depth, "body");
  }

  void choice(const IfNode& choice, int depth) {
    node(choice.condition, depth);
    node(choice.then, depth, "then");
    node(choice.otherwise, depth, "else");
  }

  void range(const Range& range, int depth) {
    node(range.from, depth);
    node(range.to, depth);
    node(range.step, depth, "by");
  }

  const Ast& ast_;
  const SourceMap& sources_;
  const SymbolTable& symbols_;
  std::string out_;
};

} // namespace

std::string dump(const Ast& ast, const SourceMap& sources, const SymbolTable& symbols) {
  Dumper dumper(ast, sources, symbols);
  dumper.node(ast.root, 0);
  return std::move(dumper).take();
}

} // namespace rt::lang
