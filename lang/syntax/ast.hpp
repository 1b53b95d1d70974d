#pragma once

#include "lang/text/source.hpp"
#include "lang/text/symbol.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rt::lang {

/// Index of a node in an `Ast`.
enum class NodeId : std::uint32_t {};
inline constexpr NodeId no_node{0xffffffff};

/// What a node is. The words name the accessor of `Ast` that reads it.
enum class Kind : std::uint8_t {
  // Items: what stands on a line of a block
  error,    ///< a syntax error, already reported; `error_name` is the name it was to declare, if any
  include,  ///< text: the path
  use,      ///< use_item
  param,    ///< param_item
  def,      ///< function: a noun; body is a block
  fn,       ///< function: a verb; body is a block or an expression
  for_,     ///< for_item; body is a block
  if_,      ///< if_node: as an item and as an expression; branches are blocks, `otherwise` may be an if_ again
  bind,     ///< bind_item
  property, ///< named: `symbol: value`
  expect,   ///< expect_item
  // Expressions
  number,  ///< number; a unit suffix is already converted to degrees, and the sign of a literal is part of it
  string,  ///< text, escapes resolved
  color,   ///< color: #rrggbb as 0xrrggbb
  boolean, ///< boolean
  none,
  name,          ///< symbol, and what check resolved it to
  previous,      ///< the thing placed last: what a line that begins with `.` edits (sessions only)
  numbers,       ///< numbers: a list of number literals only
  list,          ///< children: any other list, including the empty one
  record,        ///< children: properties
  comprehension, ///< comprehension
  lambda,        ///< function, without a name; body is an expression
  call,          ///< call
  index,         ///< index
  member,        ///< member: `base.symbol`
  override_,     ///< override_: `base { … }`
  unary,         ///< op(), operand
  binary,        ///< op(), left, right
  range,         ///< range
  // Parts
  block,     ///< children: items
  parameter, ///< parameter: a name with or without a default
  argument,  ///< named: `symbol: value` in a call
  filter,    ///< operand: `if cond` in a comprehension
  clause,    ///< for_item without a body: `for x in xs` in a comprehension
  repeat,    ///< repeat: items with the same wording (see `Repeat`)
};

enum class Op : std::uint8_t {
  or_,
  and_,
  not_,
  equal,
  not_equal,
  less,
  less_equal,
  greater,
  greater_equal,
  add,
  subtract,
  unite, // + - |
  multiply,
  divide,
  modulo,
  intersect, // * / % &
  negate,
  plus, // -x, +x
  power,
};

/// What an `expect` claims.
enum class Claim : std::uint8_t {
  holds,  ///< `expect subject`
  near,   ///< `expect subject ~ other within tolerance`
  hits,   ///< `expect subject hits other at t parameter within tolerance`
  misses, ///< `expect subject misses other`
};

/// 20 bytes; the meaning of `a` and `b` depends on the kind, and only `Ast` and the parser need to know it. `extra` and
/// (in a name) `b` belong to the stages after parsing: the parser leaves 0 and `unresolved`.
struct Node {
  Kind kind;
  Op op;
  std::uint16_t extra; ///< for check: the scope depth of a name, the slots of a block, the id of a property
  std::uint32_t begin; ///< byte offsets in the file, `end` exclusive
  std::uint32_t end;
  std::uint32_t a;
  std::uint32_t b;
};
static_assert(sizeof(Node) == 20);

inline constexpr std::uint32_t unresolved = 0xffffffff;

using NodeList = std::span<const NodeId>;

// The results of the accessors; a part that is absent is `no_node`.
struct UseItem {
  std::string_view path;
  NodeId name;
};
struct ParamItem {
  NodeId name, value, range;
};
struct Function {
  NodeId name;
  NodeList parameters;
  NodeId body;
};
struct ForItem {
  NodeId index_name, value_name, head, body;
};
struct IfNode {
  NodeId condition, then, otherwise;
};
struct BindItem {
  NodeId name, value;
};
struct ExpectItem {
  Claim claim;
  NodeId subject, other, parameter, tolerance;
};
struct Named {
  Symbol symbol;
  NodeId value;
};
struct Comprehension {
  NodeId element;
  NodeList clauses;
}; // each a clause or a filter
struct Call {
  NodeId callee;
  NodeList arguments;
}; // each an argument or an expression
struct Index {
  NodeId base, index;
};
struct Member {
  NodeId base;
  Symbol symbol;
};
struct Override {
  NodeId base, block;
};
struct Range {
  NodeId from, to, step;
  bool excludes_end;
};
struct Parameter {
  NodeId name, default_value;
};

/// Consecutive items of a block that have the wording of one item, the model, and differ only in number and colour
/// literals (a million placed spheres), with no declaration between the model and them. What check finds out about the
/// model applies to all of them. `Ast::become` turns the model into one of them; the model itself is in no block: the
/// first of its items is in its first repeat.
struct Repeat {
  NodeId model;
  NodeId model_first;         ///< the model's nodes are those from here to the model itself
  std::uint32_t first_number; ///< in `Ast::constants`
  std::uint32_t numbers_each;
  std::uint32_t first_span; ///< in `Ast::repeat_spans`
  std::uint32_t count;
  bool is_first; ///< of the repeats of this model
};

/// The syntax tree of one file: an arena of flat arrays. Children precede their parent, and the root (a block, or an
/// expression from `parse_expression`) is last.
class Ast {
public:
  FileId file = 0;
  NodeId root = no_node;
  std::vector<Node> nodes;
  std::vector<NodeId> links;     ///< lists of children
  std::vector<double> constants; ///< of `numbers` and `repeat` nodes
  std::vector<std::string> strings;
  std::vector<Repeat> repeats;
  struct Extent {
    std::uint32_t begin, end;
  };
  std::vector<Extent> repeat_spans;

  const Node& operator[](NodeId id) const { return nodes[static_cast<std::uint32_t>(id)]; }
  Node& operator[](NodeId id) { return nodes[static_cast<std::uint32_t>(id)]; }
  Kind kind(NodeId id) const { return (*this)[id].kind; }
  Op op(NodeId id) const { return (*this)[id].op; }
  Span span(NodeId id) const { return {file, (*this)[id].begin, (*this)[id].end}; }

  double number(NodeId id) const;
  void set_number(NodeId id, double value);
  bool boolean(NodeId id) const { return (*this)[id].a != 0; }
  std::uint32_t color(NodeId id) const { return (*this)[id].a; }
  std::string_view text(NodeId id) const { return strings[(*this)[id].a]; }
  std::span<const double> numbers(NodeId id) const { return {constants.data() + (*this)[id].a, (*this)[id].b}; }
  NodeList children(NodeId id) const { return {links.data() + (*this)[id].a, (*this)[id].b}; }

  /// For a name: its symbol and the slot assigned by check (in a declaration too).
  Symbol symbol(NodeId id) const { return Symbol{(*this)[id].a}; }
  std::uint32_t slot(NodeId id) const { return (*this)[id].b; }
  void set_slot(NodeId id, std::uint32_t slot, std::uint16_t depth) { (*this)[id].b = slot, (*this)[id].extra = depth; }

  Symbol error_name(NodeId id) const { return Symbol{(*this)[id].a}; }
  UseItem use_item(NodeId id) const { return {strings[(*this)[id].a], NodeId{(*this)[id].b}}; }
  ParamItem param_item(NodeId id) const;
  Function function(NodeId id) const;
  /// For a def, fn or lambda: the index assigned by check.
  std::uint32_t function_index(NodeId id) const { return static_cast<std::uint32_t>(links[(*this)[id].a + 2]); }
  void set_function_index(NodeId id, std::uint32_t index) { links[(*this)[id].a + 2] = NodeId{index}; }
  ForItem for_item(NodeId id) const;
  IfNode if_node(NodeId id) const;
  BindItem bind_item(NodeId id) const { return {NodeId{(*this)[id].a}, NodeId{(*this)[id].b}}; }
  ExpectItem expect_item(NodeId id) const;
  /// For a property or an argument; `named_span` is the span of the name.
  Named named(NodeId id) const { return {Symbol{(*this)[id].a}, NodeId{(*this)[id].b}}; }
  Span named_span(NodeId id, const SymbolTable& symbols) const;
  Comprehension comprehension(NodeId id) const;
  Call call(NodeId id) const;
  Index index(NodeId id) const { return {NodeId{(*this)[id].a}, NodeId{(*this)[id].b}}; }
  Member member(NodeId id) const { return {NodeId{(*this)[id].a}, Symbol{(*this)[id].b}}; }
  /// The span of the name after the dot.
  Span member_span(NodeId id, const SymbolTable& symbols) const;
  Override override_(NodeId id) const { return {NodeId{(*this)[id].a}, NodeId{(*this)[id].b}}; }
  /// For a unary node or a filter.
  NodeId operand(NodeId id) const { return NodeId{(*this)[id].a}; }
  NodeId left(NodeId id) const { return NodeId{(*this)[id].a}; }
  NodeId right(NodeId id) const { return NodeId{(*this)[id].b}; }
  Range range(NodeId id) const;
  Parameter parameter(NodeId id) const { return {NodeId{(*this)[id].a}, NodeId{(*this)[id].b}}; }

  const Repeat& repeat(NodeId id) const { return repeats[(*this)[id].a]; }
  /// Turns the model of a repeat into its i-th item: the number literals and the item's own span change, the inner
  /// spans stay the model's. Idempotent, and in any order.
  void become(const Repeat& repeat, std::uint32_t i);
  /// The span of the model's own text.
  Span model_span(const Repeat& repeat) const;
  Span item_span(const Repeat& repeat, std::uint32_t i) const {
    return {file, repeat_spans[repeat.first_span + i].begin, repeat_spans[repeat.first_span + i].end};
  }
};

/// Whether it is an item that binds names and places nothing, including one in error that may have been.
bool is_declaration(Kind kind);
/// How a claim is written: "hits"; empty for one without a word.
std::string_view spelling(Claim claim);
/// How an operator is written.
std::string_view spelling(Op op);

/// The tree as indented text, one node a line with line:column; repeats are counted, not listed.
std::string dump(const Ast& ast, const SourceMap& sources, const SymbolTable& symbols);

/// Whether two trees have the same meaning, whatever their layout: spans, comments and separators do not count.
bool equal(const Ast& left, const SymbolTable& left_symbols, const Ast& right, const SymbolTable& right_symbols);

} // namespace rt::lang
