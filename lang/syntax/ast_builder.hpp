#pragma once

#include "lang/syntax/ast.hpp"

#include <bit>
#include <cstdint>
#include <vector>

namespace rt::lang {

/// Thrown if an expression nests more deeply than the stages after parsing can walk.
struct TooDeep {
  std::uint32_t begin, end;
};

/// Violations of operator precedence rules; parsing continues regardless.
enum class Complaint : std::uint8_t {
  none,
  chained_comparison, ///< a < b < c
  chained_range,      ///< a .. b .. c
  misplaced_not,      ///< a == not b
  step_without_range, ///< a by b
};

/// Builds an `Ast` from the leaves up. Finished parts wait on a stack of operands until the construct around them is
/// finished and takes them; marks remember where on that stack a construct began. After a syntax error `restore`
/// returns to an earlier state, leaving nothing of the failed attempt.
class AstBuilder {
public:
  /// A finished part: its node, the height of its tree, and its extent in the text (including brackets around it).
  struct Operand {
    NodeId node;
    std::uint32_t depth;
    std::uint32_t begin, end;
  };

  /// Where an unfinished construct began. `symbol` is the name it binds its value to, if any.
  struct Mark {
    std::uint32_t operands;
    std::uint32_t begin;
    Symbol symbol;
  };

  struct Snapshot {
    std::size_t nodes, links, constants, strings, repeats, repeat_spans;
    std::size_t operands, marks, operators, frames;
  };

  AstBuilder(Ast& ast, std::uint32_t depth_limit) : ast_(ast), depth_limit_(depth_limit) {}

  Ast& ast() { return ast_; }
  const Ast& ast() const { return ast_; }
  Snapshot snapshot() const;
  void restore(const Snapshot& snapshot);
  /// Drops the nodes that were added since, but keeps the operands: their nodes must be replaced.
  void truncate_arena(const Snapshot& snapshot);

  // Leaves
  void number(std::uint32_t begin, std::uint32_t end, double value);
  void string(std::uint32_t begin, std::uint32_t end, std::string text);
  void leaf(Kind kind, std::uint32_t begin, std::uint32_t end, std::uint32_t a = 0, std::uint32_t b = 0);
  void name(std::uint32_t begin, std::uint32_t end, Symbol symbol) {
    leaf(Kind::name, begin, end, static_cast<std::uint32_t>(symbol), unresolved);
  }
  /// A placeholder for a part that is absent.
  void nothing(std::uint32_t at) { operands_.push_back({no_node, 0, at, at}); }

  // Constructs: `open`, then their parts, then one of the `close_…`; `end` is where the construct ends.
  void open(std::uint32_t begin, Symbol symbol = no_symbol) { marks_.push_back({count(), begin, symbol}); }
  /// For a construct that follows its first part, the last operand.
  void open_suffix() { marks_.push_back({count() - 1, operands_.back().begin, no_symbol}); }
  Mark& mark() { return marks_.back(); }
  std::uint32_t parts() const { return count() - marks_.back().operands; } ///< finished since the last `open`
  void close_children(Kind kind, std::uint32_t end);                       ///< block, list (or numbers), record
  void close_named(Kind kind);                                             ///< property, argument: the value
  void close_pair(Kind kind, std::uint32_t end);        ///< two parts in a and b: bind, parameter, if without its else
  void close_linked_head(Kind kind, std::uint32_t end); ///< first part in a, the others in links: param, if
  void close_loop(Kind kind, std::uint32_t end);        ///< for, clause: one or two names, head, body
  void close_function(Kind kind, std::uint32_t end);    ///< def, fn, lambda: name, parameters, body
  void close_counted(Kind kind, std::uint32_t end, std::uint32_t fixed); ///< links; b counts those after `fixed`
  void close_text(Kind kind, std::uint32_t end);     ///< include, use: a string, then perhaps a name
  void close_expect(Claim claim, std::uint32_t end); ///< four parts
  void close_filter(std::uint32_t end);

  // Suffixes of the last operand
  void member(Symbol symbol, std::uint32_t end);
  void index(std::uint32_t end); ///< base and index
  void override_block();         ///< base and block

  // Operators in order of precedence: the operands are pushed separately
  void open_expression() { frames_.push_back(static_cast<std::uint32_t>(operators_.size())); }
  Complaint prefix(Op op, std::uint32_t begin);
  Complaint infix(Op op);
  Complaint range(bool excludes_end);
  Complaint step();
  void close_expression();

  const Operand& top() const { return operands_.back(); }
  Operand& top() { return operands_.back(); }
  /// Of the parts since the last `open`.
  const Operand& part(std::uint32_t i) const { return operands_[marks_.back().operands + i]; }
  Operand& operand(std::uint32_t i) { return operands_[i]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(operands_.size()); }
  Operand pop();

private:
  NodeId add(const Node& node);
  enum class Form : std::uint8_t { prefix, infix, range, stepped_range };
  struct Operator {
    Op op;
    Form form;
    std::uint8_t precedence;
    std::uint32_t begin; ///< of a prefix operator
  };

  void push(const Node& node, std::uint32_t depth);
  std::uint32_t link(std::uint32_t first); ///< the operands from `first` on become links; returns the first link
  std::uint32_t depth_from(std::uint32_t first) const;
  bool fold_numbers(std::uint32_t first, std::uint32_t begin, std::uint32_t end);
  bool has_operator() const { return operators_.size() > frames_.back(); }
  void reduce();
  void reduce_range(bool has_step, bool excludes_end);
  void reduce_while_tighter(std::uint8_t precedence);

  Ast& ast_;
  std::uint32_t depth_limit_;
  std::vector<Operand> operands_;
  std::vector<Mark> marks_;
  std::vector<Operator> operators_;
  std::vector<std::uint32_t> frames_; ///< where in `operators_` each open expression begins
};

// What is called for every literal is inline.

inline AstBuilder::Snapshot AstBuilder::snapshot() const {
  return {ast_.nodes.size(),        ast_.links.size(), ast_.constants.size(), ast_.strings.size(), ast_.repeats.size(),
          ast_.repeat_spans.size(), operands_.size(),  marks_.size(),         operators_.size(),   frames_.size()};
}

inline NodeId AstBuilder::add(const Node& node) {
  ast_.nodes.push_back(node);
  return NodeId{static_cast<std::uint32_t>(ast_.nodes.size() - 1)};
}

inline void AstBuilder::push(const Node& node, std::uint32_t depth) {
  if (depth > depth_limit_) throw TooDeep{node.begin, node.end};
  operands_.push_back({add(node), depth, node.begin, node.end});
}

inline AstBuilder::Operand AstBuilder::pop() {
  const Operand operand = operands_.back();
  operands_.pop_back();
  return operand;
}

inline void AstBuilder::leaf(Kind kind, std::uint32_t begin, std::uint32_t end, std::uint32_t a, std::uint32_t b) {
  push({kind, Op{}, 0, begin, end, a, b}, 1);
}

inline void AstBuilder::number(std::uint32_t begin, std::uint32_t end, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  leaf(Kind::number, begin, end, static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32));
}

inline void AstBuilder::close_named(Kind kind) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const Operand value = pop();
  push({kind, Op{}, 0, mark.begin, value.end, static_cast<std::uint32_t>(mark.symbol),
        static_cast<std::uint32_t>(value.node)},
       value.depth + 1);
}

} // namespace rt::lang
