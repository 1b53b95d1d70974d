#include "lang/syntax/ast_builder.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace rt::lang {

namespace {

constexpr std::uint32_t raw(NodeId id) {
  return static_cast<std::uint32_t>(id);
}
constexpr std::uint32_t raw(Symbol symbol) {
  return static_cast<std::uint32_t>(symbol);
}

// Loosest first.
enum Precedence : std::uint8_t { p_or = 1, p_and, p_not, p_comparison, p_range, p_sum, p_product, p_sign, p_power };

std::uint8_t precedence_of(Op op) {
  switch (op) {
  case Op::or_:
    return p_or;
  case Op::and_:
    return p_and;
  case Op::not_:
    return p_not;
  case Op::equal:
  case Op::not_equal:
  case Op::less:
  case Op::less_equal:
  case Op::greater:
  case Op::greater_equal:
    return p_comparison;
  case Op::add:
  case Op::subtract:
  case Op::unite:
    return p_sum;
  case Op::multiply:
  case Op::divide:
  case Op::modulo:
  case Op::intersect:
    return p_product;
  case Op::negate:
  case Op::plus:
    return p_sign;
  case Op::power:
    return p_power;
  }
  return p_or;
}

} // namespace

void AstBuilder::truncate_arena(const Snapshot& s) {
  ast_.nodes.resize(s.nodes, Node{});
  ast_.links.resize(s.links);
  ast_.constants.resize(s.constants);
  ast_.strings.resize(s.strings);
}

void AstBuilder::restore(const Snapshot& s) {
  truncate_arena(s);
  ast_.repeats.resize(s.repeats, Repeat{});
  ast_.repeat_spans.resize(s.repeat_spans, Ast::Extent{});
  operands_.resize(s.operands, Operand{});
  marks_.resize(s.marks, Mark{});
  operators_.resize(s.operators, Operator{});
  frames_.resize(s.frames);
}

void AstBuilder::string(std::uint32_t begin, std::uint32_t end, std::string text) {
  leaf(Kind::string, begin, end, static_cast<std::uint32_t>(ast_.strings.size()));
  ast_.strings.push_back(std::move(text));
}

std::uint32_t AstBuilder::link(std::uint32_t first) {
  const auto first_link = static_cast<std::uint32_t>(ast_.links.size());
  for (std::uint32_t i = first; i < count(); ++i) ast_.links.push_back(operands_[i].node);
  return first_link;
}

std::uint32_t AstBuilder::depth_from(std::uint32_t first) const {
  std::uint32_t depth = 0;
  for (std::uint32_t i = first; i < count(); ++i) depth = std::max(depth, operands_[i].depth);
  return depth + 1;
}

// A list of number literals keeps only the numbers: their nodes, the last ones of the arena, are removed.
bool AstBuilder::fold_numbers(std::uint32_t first, std::uint32_t begin, std::uint32_t end) {
  const std::uint32_t length = count() - first;
  if (length == 0) return false;
  const auto first_node = static_cast<std::uint32_t>(ast_.nodes.size()) - length;
  for (std::uint32_t i = 0; i < length; ++i) {
    const NodeId node = operands_[first + i].node;
    if (raw(node) != first_node + i || ast_.kind(node) != Kind::number) return false;
  }
  const auto first_constant = static_cast<std::uint32_t>(ast_.constants.size());
  for (std::uint32_t i = 0; i < length; ++i) ast_.constants.push_back(ast_.number(NodeId{first_node + i}));
  ast_.nodes.resize(first_node, Node{});
  operands_.resize(first, Operand{});
  push({Kind::numbers, Op{}, 0, begin, end, first_constant, length}, 1);
  return true;
}

void AstBuilder::close_children(Kind kind, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  if (kind == Kind::list && fold_numbers(mark.operands, mark.begin, end)) return;
  const std::uint32_t length = count() - mark.operands;
  const std::uint32_t depth = depth_from(mark.operands);
  const std::uint32_t first_link = link(mark.operands);
  operands_.resize(mark.operands, Operand{});
  push({kind, Op{}, 0, mark.begin, end, first_link, length}, depth);
}

void AstBuilder::close_pair(Kind kind, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const Operand second = pop();
  const Operand first = pop();
  push({kind, Op{}, 0, mark.begin, end, raw(first.node), raw(second.node)}, std::max(first.depth, second.depth) + 1);
}

void AstBuilder::close_linked_head(Kind kind, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const std::uint32_t depth = depth_from(mark.operands);
  const std::uint32_t first_link = link(mark.operands + 1);
  const NodeId head = operands_[mark.operands].node;
  operands_.resize(mark.operands, Operand{});
  push({kind, Op{}, 0, mark.begin, end, raw(head), first_link}, depth);
}

void AstBuilder::close_counted(Kind kind, std::uint32_t end, std::uint32_t fixed) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const std::uint32_t length = count() - mark.operands;
  const std::uint32_t depth = depth_from(mark.operands);
  const std::uint32_t first_link = link(mark.operands);
  operands_.resize(mark.operands, Operand{});
  push({kind, Op{}, 0, mark.begin, end, first_link, length - fixed}, depth);
}

void AstBuilder::close_loop(Kind kind, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const bool has_body = kind == Kind::for_;
  const bool has_index = count() - mark.operands == (has_body ? 4 : 3);
  const std::uint32_t depth = depth_from(mark.operands);
  const auto first_link = static_cast<std::uint32_t>(ast_.links.size());
  if (!has_index) ast_.links.push_back(no_node);
  link(mark.operands);
  if (!has_body) ast_.links.push_back(no_node);
  operands_.resize(mark.operands, Operand{});
  push({kind, Op{}, 0, mark.begin, end, first_link, 0}, depth);
}

void AstBuilder::close_function(Kind kind, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const std::uint32_t depth = depth_from(mark.operands);
  const bool has_name = kind != Kind::lambda;
  const NodeId body = pop().node;
  const std::uint32_t parameters = mark.operands + (has_name ? 1 : 0);
  const std::uint32_t length = count() - parameters;
  const auto first_link = static_cast<std::uint32_t>(ast_.links.size());
  ast_.links.push_back(has_name ? operands_[mark.operands].node : no_node);
  ast_.links.push_back(body);
  ast_.links.push_back(no_node); // for check
  link(parameters);
  operands_.resize(mark.operands, Operand{});
  push({kind, Op{}, 0, mark.begin, end, first_link, length}, depth);
}

void AstBuilder::close_text(Kind kind, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const NodeId name = count() - mark.operands > 1 ? pop().node : no_node;
  const NodeId text = pop().node;
  push({kind, Op{}, 0, mark.begin, end, ast_[text].a, raw(name)}, 2);
}

void AstBuilder::close_expect(Claim claim, std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const std::uint32_t depth = depth_from(mark.operands);
  const std::uint32_t first_link = link(mark.operands);
  operands_.resize(mark.operands, Operand{});
  push({Kind::expect, Op{}, 0, mark.begin, end, first_link, static_cast<std::uint32_t>(claim)}, depth);
}

void AstBuilder::close_filter(std::uint32_t end) {
  const Mark mark = marks_.back();
  marks_.pop_back();
  const Operand condition = pop();
  push({Kind::filter, Op{}, 0, mark.begin, end, raw(condition.node), 0}, condition.depth + 1);
}

void AstBuilder::member(Symbol symbol, std::uint32_t end) {
  const Operand base = pop();
  push({Kind::member, Op{}, 0, base.begin, end, raw(base.node), raw(symbol)}, base.depth + 1);
}

void AstBuilder::index(std::uint32_t end) {
  const Operand index = pop();
  const Operand base = pop();
  push({Kind::index, Op{}, 0, base.begin, end, raw(base.node), raw(index.node)}, std::max(base.depth, index.depth) + 1);
}

void AstBuilder::override_block() {
  const Operand block = pop();
  const Operand base = pop();
  push({Kind::override_, Op{}, 0, base.begin, block.end, raw(base.node), raw(block.node)},
       std::max(base.depth, block.depth) + 1);
}

Complaint AstBuilder::prefix(Op op, std::uint32_t begin) {
  std::uint8_t precedence = precedence_of(op);
  Complaint complaint = Complaint::none;
  if (op == Op::not_ && has_operator() && operators_.back().precedence > p_not) {
    complaint = Complaint::misplaced_not;
    precedence = p_sign;
  }
  operators_.push_back({op, Form::prefix, precedence, begin});
  return complaint;
}

Complaint AstBuilder::infix(Op op) {
  const std::uint8_t precedence = precedence_of(op);
  reduce_while_tighter(precedence);
  Complaint complaint = Complaint::none;
  const bool follows_equal =
      has_operator() && operators_.back().precedence == precedence && operators_.back().form != Form::prefix;
  if (follows_equal && precedence == p_comparison) complaint = Complaint::chained_comparison;
  if (follows_equal && op != Op::power) reduce();
  operators_.push_back({op, Form::infix, precedence, 0});
  return complaint;
}

Complaint AstBuilder::range(bool excludes_end) {
  reduce_while_tighter(p_range);
  Complaint complaint = Complaint::none;
  if (has_operator() && operators_.back().precedence == p_range) {
    complaint = Complaint::chained_range;
    reduce();
  }
  operators_.push_back({excludes_end ? Op::less : Op::less_equal, Form::range, p_range, 0});
  return complaint;
}

Complaint AstBuilder::step() {
  reduce_while_tighter(p_range);
  if (has_operator() && operators_.back().form == Form::range) {
    operators_.back().form = Form::stepped_range;
    return Complaint::none;
  }
  operators_.push_back({Op::multiply, Form::infix, p_range, 0}); // a placeholder; the complaint is an error
  return Complaint::step_without_range;
}

void AstBuilder::close_expression() {
  while (has_operator()) reduce();
  frames_.pop_back();
}

void AstBuilder::reduce_while_tighter(std::uint8_t precedence) {
  while (has_operator() && operators_.back().precedence > precedence) reduce();
}

void AstBuilder::reduce() {
  const Operator op = operators_.back();
  operators_.pop_back();
  if (op.form == Form::range || op.form == Form::stepped_range) {
    return reduce_range(op.form == Form::stepped_range, op.op == Op::less);
  }
  const Operand right = pop();
  if (op.form == Form::prefix) {
    if (op.op != Op::not_ && ast_.kind(right.node) == Kind::number) { // a sign is part of the literal
      if (op.op == Op::negate) ast_.set_number(right.node, -ast_.number(right.node));
      ast_[right.node].begin = op.begin;
      operands_.push_back({right.node, 1, op.begin, right.end});
      return;
    }
    return push({Kind::unary, op.op, 0, op.begin, right.end, raw(right.node), 0}, right.depth + 1);
  }
  const Operand left = pop();
  push({Kind::binary, op.op, 0, left.begin, right.end, raw(left.node), raw(right.node)},
       std::max(left.depth, right.depth) + 1);
}

void AstBuilder::reduce_range(bool has_step, bool excludes_end) {
  if (!has_step) nothing(top().end);
  const std::uint32_t first = count() - 3;
  const std::uint32_t begin = operands_[first].begin;
  const std::uint32_t end = operands_.back().end;
  const std::uint32_t depth = depth_from(first);
  const NodeId from = operands_[first].node;
  const std::uint32_t first_link = link(first + 1);
  operands_.resize(first, Operand{});
  push({Kind::range, excludes_end ? Op::less : Op::less_equal, 0, begin, end, raw(from), first_link}, depth);
}

} // namespace rt::lang
