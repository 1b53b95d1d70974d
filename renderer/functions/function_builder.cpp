#include "renderer/functions/function_builder.hpp"

#include "renderer/functions/apply.hpp"
#include "renderer/math/hashing.hpp"

#include <bit>

namespace rt {

namespace {

constexpr std::uint32_t place(FunctionBuilder::Node node) {
  return static_cast<std::uint32_t>(node);
}

} // namespace

std::size_t FunctionBuilder::KeyHash::operator()(const Instruction& key) const {
  const std::uint64_t head = static_cast<std::uint64_t>(key.operation) << 16 | key.seed;
  return Hasher().add(head).add(std::uint64_t{key.a} << 32 | key.b).add(std::uint64_t{key.c}).value();
}

FunctionBuilder::FunctionBuilder(std::uint32_t input_count)
    : input_count_(input_count), entries_(input_count, ValueNode{ValueNode::Kind::input, 0, {}}) {}

FunctionBuilder::Node FunctionBuilder::constant(double value) {
  if (!std::isfinite(value)) {
    const double sign = std::isnan(value) ? 0 : value > 0 ? 1 : -1;
    return apply(Opcode::divide, constant(sign), constant(0));
  }
  const auto [found, is_new] =
      constants_.try_emplace(std::bit_cast<std::uint64_t>(value), Node{static_cast<std::uint32_t>(entries_.size())});
  if (is_new) entries_.push_back({ValueNode::Kind::constant, value, {}});
  return found->second;
}

std::optional<double> FunctionBuilder::constant_value(Node node) const {
  const ValueNode& entry = entries_[place(node)];
  return entry.kind == ValueNode::Kind::constant ? std::optional(entry.value) : std::nullopt;
}

// What is infinite or has no value stays an instruction: constants are finite.
std::optional<double> FunctionBuilder::folded(Opcode operation, Node a, Node b, Node c) const {
  const int count = operand_count(operation);
  const auto x = constant_value(a), y = count > 1 ? constant_value(b) : 0.0, z = count > 2 ? constant_value(c) : 0.0;
  if (!x || !y || !z) return std::nullopt;
  const double value = dispatch(operation, [&]<Opcode known>() {
    if constexpr (known == Opcode::noise)
      return std::numeric_limits<double>::quiet_NaN();
    else
      return rt::apply<known>(*x, *y, *z);
  });
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// Only what is the same to the last bit: x + 0 is not, where x is −0.
std::optional<FunctionBuilder::Node> FunctionBuilder::simplified(Opcode operation, Node a, Node b, Node c) const {
  const auto is = [&](Node node, double value) {
    const auto known = constant_value(node);
    return known && std::bit_cast<std::uint64_t>(*known) == std::bit_cast<std::uint64_t>(value);
  };
  switch (operation) {
  case Opcode::multiply:
    if (is(a, 1)) return b;
    if (is(b, 1)) return a;
    break;
  case Opcode::divide:
    if (is(b, 1)) return a;
    break;
  case Opcode::subtract:
    if (is(b, 0)) return a;
    break;
  case Opcode::minimum:
  case Opcode::maximum:
    if (a == b) return a;
    break;
  case Opcode::select:
    if (b == c) return b;
    if (const auto condition = constant_value(a)) return *condition != 0 ? b : c;
    break;
  default:
    break;
  }
  return std::nullopt;
}

FunctionBuilder::Node FunctionBuilder::apply(Opcode operation, Node a, Node b, Node c) {
  const int count = operand_count(operation);
  if (count < 2) b = {};
  if (count < 3) c = {};
  if (const auto same = simplified(operation, a, b, c)) return *same;
  if (const auto value = folded(operation, a, b, c)) return constant(*value);
  return add({operation, 0, place(a), place(b), place(c)});
}

FunctionBuilder::Node FunctionBuilder::noise(std::uint64_t seed, Node x, Node y, Node z) {
  const auto [found, is_new] = seed_indices_.try_emplace(seed, static_cast<std::uint16_t>(seeds_.size()));
  if (is_new) seeds_.push_back(seed);
  return add({Opcode::noise, found->second, place(x), place(y), place(z)});
}

FunctionBuilder::Node FunctionBuilder::add(Instruction instruction) {
  const auto [found, is_new] =
      instructions_.try_emplace(instruction, Node{static_cast<std::uint32_t>(entries_.size())});
  if (!is_new) return found->second;
  entries_.push_back({ValueNode::Kind::instruction, 0, instruction});
  ++instruction_count_;
  return found->second;
}

Function FunctionBuilder::finish(std::span<const Node> results) const {
  std::vector<bool> is_needed(entries_.size());
  for (const Node result : results) is_needed[place(result)] = true;
  for (std::size_t i = entries_.size(); i-- > 0;) {
    if (!is_needed[i] || entries_[i].kind != ValueNode::Kind::instruction) continue;
    const Instruction& step = entries_[i].instruction;
    const Register operands[] = {step.a, step.b, step.c};
    for (int k = 0; k < operand_count(step.operation); ++k) is_needed[operands[k]] = true;
  }

  Function function;
  function.input_count = input_count_;
  function.seeds = seeds_;
  std::vector<Register> registers(entries_.size());
  for (std::uint32_t i = 0; i < input_count_; ++i) registers[i] = i;
  for (std::size_t i = input_count_; i < entries_.size(); ++i) {
    if (!is_needed[i] || entries_[i].kind != ValueNode::Kind::constant) continue;
    registers[i] = static_cast<Register>(input_count_ + function.constants.size());
    function.constants.push_back(entries_[i].value);
  }
  for (std::size_t i = input_count_; i < entries_.size(); ++i) {
    if (!is_needed[i] || entries_[i].kind != ValueNode::Kind::instruction) continue;
    registers[i] = static_cast<Register>(function.register_count());
    const Instruction& step = entries_[i].instruction;
    const int count = operand_count(step.operation);
    function.code.push_back({step.operation, step.seed, registers[step.a], count > 1 ? registers[step.b] : 0,
                             count > 2 ? registers[step.c] : 0});
  }
  for (const Node result : results) function.results.push_back(registers[place(result)]);
  return function;
}

} // namespace rt
