#pragma once

#include "lang/syntax/ast_builder.hpp"
#include "lang/syntax/repeat_text.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {

/// Finds items that differ from an earlier item of their block only in number and colour literals, and stores the
/// literals instead of the nodes (`Repeat`): a million placed spheres then take 40 bytes each, and are checked once.
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
    forget_models(); // the broken item may have been a declaration
  }

  /// The last operand is a whole item, begun at `before`. `text` is the source, if it can be trusted: then
  /// `repeat_item` will know the item's wording.
  void finish_item(const AstBuilder::Snapshot& before, std::optional<std::string_view> text);

  /// If an item at `begin` repeats one by its text alone, it becomes the last operand or joins the repeat there,
  /// bypassing the grammar. Returns where it ends.
  std::optional<std::uint32_t> repeat_item(std::string_view text, std::uint32_t begin);

private:
  /// An item that others may repeat, and its position in the arena.
  struct Model {
    std::uint64_t hash; ///< of the wording
    std::uint32_t first_node, last_node, first_link, links;
    std::uint32_t operand; ///< its index on the builder's stack
    bool is_repeated = false;
    std::optional<RepeatText> repeat_text{};
  };
  struct Block {
    std::uint32_t first_operand = 0;
    std::uint32_t first_model = 0;
  };

  void forget_models() { models_.resize(blocks_.back().first_model, Model{}); }
  std::span<const Model> known_models() const { return std::span(models_).subspan(blocks_.back().first_model); }
  Model* find(std::uint64_t hash);
  bool is_foldable(std::uint32_t first_node, std::uint32_t last_node) const;
  std::uint64_t hash(const Model& item) const;
  bool has_wording_of(const Model& item, const Model& model) const;
  void take_literals(const Model& item, std::vector<double>& literals) const;
  void learn_wording(Model& model, std::string_view text) const;
  void begin_repeat(const Model& model, std::uint32_t operand, const std::vector<double>& literals, bool is_first);
  bool extend_repeat(const Model& model);

  AstBuilder& builder_;
  std::vector<Block> blocks_;
  std::vector<Model> models_;    ///< of all open blocks, the innermost last
  std::vector<double> literals_; ///< of the current item
};

} // namespace rt::lang
