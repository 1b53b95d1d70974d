#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rt::lang {

/// The text of an item with its numbers removed. Whatever numbers are in their places, the grammar parses it the same
/// way: between them it is byte-identical, and each is a number by itself, after `[`, `,` or `:` and before `]`, `}`,
/// `,`, `;` or the end of a line that the next one does not continue.
class RepeatText {
public:
  /// For an item that ends with a brace and whose number literals the grammar found to be these. None if the text
  /// leaves any doubt about them.
  static std::optional<RepeatText> of(std::string_view item, std::span<const double> literals);

  /// Whether both have the same pieces in the half-open range from `first` to `last`.
  bool agrees(const RepeatText& other, std::size_t first, std::size_t last) const;
  std::size_t numbers() const { return pieces_.size() - 1; }
  /// What precedes the i-th number; finally, what follows the last.
  std::string_view piece(std::size_t i) const { return pieces_[i]; }

private:
  std::vector<std::string_view> pieces_; // of the source text
};

/// Whether an item that could end here, after its brace, does: a comma or the end of the line says so if no dot, brace
/// or comment follows.
bool ends_item(std::string_view text, std::uint32_t at);

} // namespace rt::lang
