#include "lang/syntax/ast.hpp"

#include <algorithm>
#include <bit>

namespace rt::lang {

namespace {

struct Comparison {
  const Ast& left;
  const SymbolTable& left_symbols;
  const Ast& right;
  const SymbolTable& right_symbols;

  bool names(Symbol a, Symbol b) const {
    if (a == no_symbol || b == no_symbol) return a == b;
    return left_symbols.name(a) == right_symbols.name(b);
  }

  bool lists(NodeList a, NodeList b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [this](NodeId x, NodeId y) { return nodes(x, y); });
  }

  // Bitwise: -0 differs from 0, and a tree equals itself whatever its numbers are.
  static bool numbers(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

  bool number_lists(std::span<const double> a, std::span<const double> b) const {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), numbers);
  }

  bool nodes(NodeId a, NodeId b) const {
    if (a == no_node || b == no_node) return a == b;
    return left.kind(a) == right.kind(b) && parts(a, b);
  }

  bool parts(NodeId a, NodeId b) const {
    switch (left.kind(a)) {
    case Kind::none:
    case Kind::previous:
      return true;
    case Kind::error:
      return names(left.error_name(a), right.error_name(b));
    case Kind::include:
    case Kind::string:
      return left.text(a) == right.text(b);
    case Kind::use:
      return left.text(a) == right.text(b) && nodes(left.use_item(a).name, right.use_item(b).name);
    case Kind::number:
      return numbers(left.number(a), right.number(b));
    case Kind::color:
      return left.color(a) == right.color(b);
    case Kind::boolean:
      return left.boolean(a) == right.boolean(b);
    case Kind::name:
      return names(left.symbol(a), right.symbol(b));
    case Kind::numbers:
      return number_lists(left.numbers(a), right.numbers(b));
    case Kind::block:
    case Kind::list:
    case Kind::record:
      return lists(left.children(a), right.children(b));
    case Kind::param:
      return same(left.param_item(a), right.param_item(b));
    case Kind::def:
    case Kind::fn:
    case Kind::lambda:
      return same(left.function(a), right.function(b));
    case Kind::for_:
    case Kind::clause:
      return same(left.for_item(a), right.for_item(b));
    case Kind::if_:
      return same(left.if_node(a), right.if_node(b));
    case Kind::expect:
      return same(left.expect_item(a), right.expect_item(b));
    case Kind::property:
    case Kind::argument:
      return names(left.named(a).symbol, right.named(b).symbol) && nodes(left.named(a).value, right.named(b).value);
    case Kind::comprehension:
      return nodes(left.comprehension(a).element, right.comprehension(b).element) &&
             lists(left.comprehension(a).clauses, right.comprehension(b).clauses);
    case Kind::call:
      return nodes(left.call(a).callee, right.call(b).callee) && lists(left.call(a).arguments, right.call(b).arguments);
    case Kind::member:
      return names(left.member(a).symbol, right.member(b).symbol) && nodes(left.member(a).base, right.member(b).base);
    case Kind::unary:
    case Kind::filter:
      return left.op(a) == right.op(b) && nodes(left.operand(a), right.operand(b));
    case Kind::range:
      return same(left.range(a), right.range(b));
    case Kind::bind:
    case Kind::index:
    case Kind::override_:
    case Kind::parameter:
    case Kind::binary: // two children each
      return left.op(a) == right.op(b) && nodes(left.left(a), right.left(b)) && nodes(left.right(a), right.right(b));
    case Kind::repeat:
      return left.repeat(a).count == right.repeat(b).count;
    }
    return false;
  }

  bool same(const ParamItem& a, const ParamItem& b) const {
    return nodes(a.name, b.name) && nodes(a.value, b.value) && nodes(a.range, b.range);
  }
  bool same(const ExpectItem& a, const ExpectItem& b) const {
    return a.claim == b.claim && nodes(a.subject, b.subject) && nodes(a.other, b.other) &&
           nodes(a.parameter, b.parameter) && nodes(a.tolerance, b.tolerance);
  }
  bool same(const Function& a, const Function& b) const {
    return nodes(a.name, b.name) && lists(a.parameters, b.parameters) && nodes(a.body, b.body);
  }
  bool same(const ForItem& a, const ForItem& b) const {
    return nodes(a.index_name, b.index_name) && nodes(a.value_name, b.value_name) && nodes(a.head, b.head) &&
           nodes(a.body, b.body);
  }
  bool same(const IfNode& a, const IfNode& b) const {
    return nodes(a.condition, b.condition) && nodes(a.then, b.then) && nodes(a.otherwise, b.otherwise);
  }
  bool same(const Range& a, const Range& b) const {
    return a.excludes_end == b.excludes_end && nodes(a.from, b.from) && nodes(a.to, b.to) && nodes(a.step, b.step);
  }
};

} // namespace

bool equal(const Ast& left, const SymbolTable& left_symbols, const Ast& right, const SymbolTable& right_symbols) {
  return Comparison{left, left_symbols, right, right_symbols}.nodes(left.root, right.root);
}

} // namespace rt::lang
