#pragma once

#include "renderer/functions/function.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace rt {

/// Builds a function step by step. What is the same is there once, what is constant is computed at once, and what no
/// result needs is left out in the end.
class FunctionBuilder {
public:
  /// A value of the function being built.
  enum class Node : std::uint32_t {};

  explicit FunctionBuilder(std::uint32_t input_count);

  Node input(std::uint32_t i) const { return Node{i}; }
  /// One that is not finite is made by a division by 0.
  Node constant(double value);
  /// Operands that the operation does not have are passed over.
  Node apply(Opcode operation, Node a, Node b = {}, Node c = {});
  Node noise(std::uint64_t seed, Node x, Node y, Node z);

  /// The value of a node that is constant.
  std::optional<double> constant_value(Node node) const;
  /// How many instructions there are, needed or not.
  std::size_t size() const { return instruction_count_; }
  /// The function with one or three results; it has at most `most_instructions` if that many were built.
  Function finish(std::span<const Node> results) const;

private:
  // An input, a constant or an instruction; operands are places of entries before it.
  struct ValueNode {
    enum class Kind : std::uint8_t { input, constant, instruction } kind;
    double value = 0; // of a constant
    Instruction instruction;
  };
  struct KeyHash {
    std::size_t operator()(const Instruction& key) const;
  };
  std::optional<Node> simplified(Opcode operation, Node a, Node b, Node c) const;
  std::optional<double> folded(Opcode operation, Node a, Node b, Node c) const;
  Node add(Instruction instruction);

  std::uint32_t input_count_;
  std::size_t instruction_count_ = 0;
  std::vector<ValueNode> entries_;
  std::vector<std::uint64_t> seeds_;
  std::unordered_map<std::uint64_t, Node> constants_; // by the bits of the value
  std::unordered_map<std::uint64_t, std::uint16_t> seed_indices_;
  std::unordered_map<Instruction, Node, KeyHash> instructions_;
};

} // namespace rt
