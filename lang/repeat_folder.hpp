#pragma once

#include "lang/ast_builder.hpp"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace rt::lang {

/// Finds items that differ from an earlier item of their block in number and colour literals alone, and keeps the literals
/// in place of the nodes (`Repeat`). A million placed spheres then take 60 bytes each, and are checked once.
class RepeatFolder {
public:
  void open_block(std::uint32_t first_operand);
  void close_block();
  /// The last operand is an item whose nodes, links and constants follow those of `before`.
  void finish_item(AstBuilder& builder, const AstBuilder::Snapshot& before);

private:
  /// An item as it lies in the arena.
  struct Model {
    std::uint32_t node_begin, node_end, link_begin, link_end;
    std::uint32_t numbers;     ///< how many literals vary
    std::uint32_t operand;     ///< where the item stands among the operands
    bool is_folded = false;    ///< the item itself stands as a repeat
  };
  struct Block {
    std::uint32_t first_operand;
    std::unordered_map<std::uint64_t, Model> models; ///< by the hash of their wording
  };

  std::vector<Block> blocks_;
};

} // namespace rt::lang
