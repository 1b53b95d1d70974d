#pragma once

#include "lang/ast_builder.hpp"

#include <cstdint>
#include <vector>

namespace rt::lang {

/// Finds items that differ from an earlier item of their block in number and colour literals alone, and keeps the
/// literals in place of the nodes (`Repeat`): a million placed spheres then take 40 bytes each, and are checked once.
class RepeatFolder {
public:
  explicit RepeatFolder(AstBuilder& builder) : builder_(builder) {}

  void open_block() { blocks_.push_back({builder_.count(), static_cast<std::uint32_t>(models_.size())}); }
  void close_block() {
    forget_models();
    blocks_.pop_back();
  }
  std::size_t depth() const { return blocks_.size(); }
  /// After an error: only the outer blocks are still open.
  void restore(std::size_t depth) {
    blocks_.resize(depth);
    forget_models(); // what is broken may have been a declaration
  }

  /// The last operand is a whole item, begun at `before`.
  void finish_item(const AstBuilder::Snapshot& before);

private:
  /// An item that others may repeat, and where it lies in the arena.
  struct Model {
    std::uint64_t hash; ///< of the wording
    std::uint32_t first_node, last_node, first_link, links;
    std::uint32_t operand; ///< where it stands on the builder's stack
    bool is_repeated = false;
  };
  struct Block {
    std::uint32_t first_operand = 0;
    std::uint32_t first_model = 0;
  };

  void forget_models() { models_.resize(blocks_.back().first_model, Model{}); }
  Model* find(std::uint64_t hash);
  bool is_foldable(std::uint32_t first_node, std::uint32_t last_node) const;
  std::uint64_t hash(const Model& item) const;
  bool has_wording_of(const Model& item, const Model& model) const;
  void take_literals(const Model& item, std::vector<double>& literals) const;
  void begin_repeat(const Model& model, std::uint32_t operand, const std::vector<double>& literals, bool is_first);
  bool extend_repeat(const Model& model);

  AstBuilder& builder_;
  std::vector<Block> blocks_;
  std::vector<Model> models_;    ///< of all open blocks, the innermost last
  std::vector<double> literals_; ///< of the item at hand
};

} // namespace rt::lang
