#include "lang/syntax/ast.hpp"

#include <algorithm>
#include <bit>

namespace rt::lang {

double Ast::number(NodeId id) const {
  const Node& node = (*this)[id];
  return std::bit_cast<double>(std::uint64_t{node.b} << 32 | node.a);
}

ParamItem Ast::param_item(NodeId id) const {
  const Node& node = (*this)[id];
  return {NodeId{node.a}, links[node.b], links[node.b + 1]};
}

Function Ast::function(NodeId id) const {
  const Node& node = (*this)[id];
  return {links[node.a], {links.data() + node.a + 3, node.b}, links[node.a + 1]};
}

ForItem Ast::for_item(NodeId id) const {
  const NodeId* part = links.data() + (*this)[id].a;
  return {part[0], part[1], part[2], part[3]};
}

ExpectItem Ast::expect_item(NodeId id) const {
  const Node& node = (*this)[id];
  const NodeId* part = links.data() + node.a;
  return {static_cast<Claim>(node.b), part[0], part[1], part[2], part[3]};
}

IfNode Ast::if_node(NodeId id) const {
  const Node& node = (*this)[id];
  return {NodeId{node.a}, links[node.b], links[node.b + 1]};
}

Comprehension Ast::comprehension(NodeId id) const {
  const Node& node = (*this)[id];
  return {links[node.a], {links.data() + node.a + 1, node.b}};
}

Call Ast::call(NodeId id) const {
  const Node& node = (*this)[id];
  return {links[node.a], {links.data() + node.a + 1, node.b}};
}

Range Ast::range(NodeId id) const {
  const Node& node = (*this)[id];
  return {NodeId{node.a}, links[node.b], links[node.b + 1], node.op == Op::less};
}

Span Ast::named_span(NodeId id, const SymbolTable& symbols) const {
  const std::uint32_t begin = (*this)[id].begin;
  return {file, begin, begin + static_cast<std::uint32_t>(symbols.name(named(id).symbol).size())};
}

Span Ast::member_span(NodeId id, const SymbolTable& symbols) const {
  const std::uint32_t end = (*this)[id].end;
  return {file, end - static_cast<std::uint32_t>(symbols.name(member(id).symbol).size()), end};
}

void Ast::set_number(NodeId id, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  (*this)[id].a = static_cast<std::uint32_t>(bits);
  (*this)[id].b = static_cast<std::uint32_t>(bits >> 32);
}

// Not taken from the model itself, which has the place of the item it became.
Span Ast::model_span(const Repeat& repeat) const {
  const Node& first = nodes[static_cast<std::uint32_t>(repeat.model_first)];
  Span span{file, first.begin, first.end};
  for (auto n = static_cast<std::uint32_t>(repeat.model_first); n < static_cast<std::uint32_t>(repeat.model); ++n) {
    span.begin = std::min(span.begin, nodes[n].begin);
    span.end = std::max(span.end, nodes[n].end);
  }
  return span;
}

void Ast::become(const Repeat& repeat, std::uint32_t i) {
  const double* next = constants.data() + repeat.first_number + std::size_t{i} * repeat.numbers_each;
  const auto model = static_cast<std::uint32_t>(repeat.model);
  for (auto n = static_cast<std::uint32_t>(repeat.model_first); n < model; ++n) {
    Node& node = nodes[n];
    if (node.kind == Kind::number) {
      set_number(NodeId{n}, *next++);
    } else if (node.kind == Kind::color) {
      node.a = static_cast<std::uint32_t>(*next++);
    } else if (node.kind == Kind::numbers) {
      for (std::uint32_t k = 0; k < node.b; ++k) constants[node.a + k] = *next++;
    }
  }
  nodes[model].begin = repeat_spans[repeat.first_span + i].begin;
  nodes[model].end = repeat_spans[repeat.first_span + i].end;
}

bool is_declaration(Kind kind) {
  switch (kind) {
  case Kind::error:
  case Kind::include:
  case Kind::use:
  case Kind::param:
  case Kind::def:
  case Kind::fn:
  case Kind::bind:
    return true;
  default:
    return false;
  }
}

std::string_view spelling(Claim claim) {
  switch (claim) {
  case Claim::near:
    return "~";
  case Claim::hits:
    return "hits";
  case Claim::misses:
    return "misses";
  case Claim::holds:
    break;
  }
  return "";
}

std::string_view spelling(Op op) {
  switch (op) {
  case Op::or_:
    return "or";
  case Op::and_:
    return "and";
  case Op::not_:
    return "not";
  case Op::equal:
    return "==";
  case Op::not_equal:
    return "!=";
  case Op::less:
    return "<";
  case Op::less_equal:
    return "<=";
  case Op::greater:
    return ">";
  case Op::greater_equal:
    return ">=";
  case Op::add:
    return "+";
  case Op::subtract:
    return "-";
  case Op::unite:
    return "|";
  case Op::multiply:
    return "*";
  case Op::divide:
    return "/";
  case Op::modulo:
    return "%";
  case Op::intersect:
    return "&";
  case Op::plus:
    return "+";
  case Op::negate:
    return "-";
  case Op::power:
    return "^";
  }
  return "";
}

} // namespace rt::lang
