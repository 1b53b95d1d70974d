#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {

/// The text of an item with its numbers taken out. Whatever numbers stand in their places, the grammar reads it in one
/// way: between them it is the same byte by byte, and each is a number and nothing else, on its own after `[`, `,` or
/// `:` and before `]`, `}`, `,`, `;` or the end of a line that the next one does not continue.
class RepeatText {
public:
  /// Of an item that ends with a brace and whose number literals the grammar found to be these. None where the text
  /// leaves any doubt about them.
  static std::optional<RepeatText> of(std::string_view item, std::span<const double> literals);

  /// Whether both have the same pieces from the first to before the last of these places.
  bool agrees(const RepeatText& other, std::size_t first, std::size_t last) const;
  std::size_t numbers() const { return pieces_.size() - 1; }
  /// What stands before the i-th number, and in the end after the last.
  std::string_view piece(std::size_t i) const { return pieces_[i]; }

private:
  std::vector<std::string_view> pieces_; // of the source text
};

/// Whether an item that could end here, behind its brace, does: that is what a comma or the end of the line says if no
/// dot, brace or comment follows.
bool ends_item(std::string_view text, std::uint32_t at);

} // namespace rt::lang
