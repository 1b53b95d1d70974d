#include "tests/support/parsing.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace rt::tests {

using namespace lang;

std::vector<std::string> Text::codes() const {
  std::vector<std::string> out;
  for (const Diagnostic& diagnostic : parsed.diagnostics) out.push_back(diagnostic.code);
  return out;
}

std::string Text::report() const {
  std::string out;
  for (const Diagnostic& diagnostic : parsed.diagnostics) out += render(diagnostic, sources, false);
  return out;
}

Text parse_text(std::string text, const ParseOptions& options) {
  Text out;
  const FileId file = out.sources.add("test.rtl", "", std::move(text));
  out.parsed = parse(out.sources, file, out.symbols, options);
  return out;
}

namespace {

class Shape {
public:
  Shape(const Ast& ast, const SymbolTable& symbols) : ast_(ast), symbols_(symbols) {}

  std::string of(NodeId id) const {
    if (id == no_node) return "_";
    switch (ast_.kind(id)) {
    case Kind::error:
      return ast_.error_name(id) == no_symbol ? "ERROR" : fmt::format("ERROR:{}", name(ast_.error_name(id)));
    case Kind::include:
      return fmt::format("(include {})", ast_.text(id));
    case Kind::use:
      return fmt::format("(use {} {})", ast_.text(id), of(ast_.use_item(id).name));
    case Kind::param:
      return form("param", {ast_.param_item(id).name, ast_.param_item(id).value, ast_.param_item(id).range});
    case Kind::def:
      return function("def", id);
    case Kind::fn:
      return function("fn", id);
    case Kind::lambda:
      return function("lambda", id);
    case Kind::for_:
      return loop("for", id);
    case Kind::clause:
      return loop("clause", id);
    case Kind::if_:
      return form("if", {ast_.if_node(id).condition, ast_.if_node(id).then, ast_.if_node(id).otherwise});
    case Kind::bind:
      return form("=", {ast_.bind_item(id).name, ast_.bind_item(id).value});
    case Kind::expect: {
      const ExpectItem item = ast_.expect_item(id);
      return form(fmt::format("expect{}", spelling(item.claim)),
                  {item.subject, item.other, item.parameter, item.tolerance});
    }
    case Kind::property:
    case Kind::argument:
      return fmt::format("{}: {}", name(ast_.named(id).symbol), of(ast_.named(id).value));
    case Kind::number:
      return fmt::format("{}", ast_.number(id));
    case Kind::string:
      return fmt::format("\"{}\"", ast_.text(id));
    case Kind::color:
      return fmt::format("#{:06x}", ast_.color(id));
    case Kind::boolean:
      return ast_.boolean(id) ? "true" : "false";
    case Kind::none:
      return "none";
    case Kind::name:
      return std::string(name(ast_.symbol(id)));
    case Kind::previous:
      return "previous";
    case Kind::numbers:
      return fmt::format("[{}]", fmt::join(ast_.numbers(id), " "));
    case Kind::list:
      return fmt::format("[{}]", list(ast_.children(id), " "));
    case Kind::record:
      return fmt::format("{{{}}}", list(ast_.children(id), ", "));
    case Kind::comprehension:
      return fmt::format("[{} {}]", of(ast_.comprehension(id).element), list(ast_.comprehension(id).clauses, " "));
    case Kind::call:
      return fmt::format("(call {} {})", of(ast_.call(id).callee), list(ast_.call(id).arguments, " "));
    case Kind::index:
      return form("index", {ast_.index(id).base, ast_.index(id).index});
    case Kind::member:
      return fmt::format("(. {} {})", of(ast_.member(id).base), name(ast_.member(id).symbol));
    case Kind::override_:
      return fmt::format("{}{}", of(ast_.override_(id).base), of(ast_.override_(id).block));
    case Kind::unary:
      return form(spelling(ast_.op(id)), {ast_.operand(id)});
    case Kind::binary:
      return form(spelling(ast_.op(id)), {ast_.left(id), ast_.right(id)});
    case Kind::range:
      return form(ast_.range(id).excludes_end ? "..<" : "..",
                  {ast_.range(id).from, ast_.range(id).to, ast_.range(id).step});
    case Kind::block:
      return fmt::format("{{{}}}", list(ast_.children(id), "; "));
    case Kind::parameter:
      return ast_.parameter(id).default_value == no_node
                 ? of(ast_.parameter(id).name)
                 : fmt::format("{}={}", of(ast_.parameter(id).name), of(ast_.parameter(id).default_value));
    case Kind::filter:
      return form("filter", {ast_.operand(id)});
    case Kind::repeat:
      return fmt::format("(repeat {})", ast_.repeat(id).count);
    }
    return "?";
  }

private:
  std::string_view name(Symbol symbol) const { return symbols_.name(symbol); }

  std::string list(NodeList ids, std::string_view separator) const {
    std::vector<std::string> parts;
    for (const NodeId id : ids) parts.push_back(of(id));
    return fmt::format("{}", fmt::join(parts, separator));
  }

  std::string form(std::string_view head, const std::vector<NodeId>& parts) const {
    return fmt::format("({} {})", head, list(parts, " "));
  }

  std::string function(std::string_view head, NodeId id) const {
    const Function f = ast_.function(id);
    return fmt::format("({} {} ({}) {})", head, of(f.name), list(f.parameters, " "), of(f.body));
  }

  std::string loop(std::string_view head, NodeId id) const {
    const ForItem f = ast_.for_item(id);
    return form(head, {f.index_name, f.value_name, f.head, f.body});
  }

  const Ast& ast_;
  const SymbolTable& symbols_;
};

} // namespace

std::string shape(const Ast& ast, const SymbolTable& symbols, NodeId id) {
  return Shape(ast, symbols).of(id);
}

std::string shape(const Text& text) {
  const std::string block = shape(text.ast(), text.symbols, text.ast().root);
  return block.substr(1, block.size() - 2);
}

std::string parsed(std::string text) {
  const Text out = parse_text(std::move(text));
  INFO(out.report());
  CHECK(out.codes().empty());
  return shape(out);
}

} // namespace rt::tests
