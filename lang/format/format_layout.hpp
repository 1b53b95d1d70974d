#pragma once

#include "lang/format/format_tree.hpp"

/// The formatter's decisions: where spaces and line breaks go.
namespace rt::lang::layout {

inline constexpr std::size_t widest = 100; ///< columns
inline constexpr std::size_t step = 2;     ///< of indentation

/// Whether a space precedes piece `i`, which is not the first.
bool has_space_before(const std::vector<Piece>& pieces, std::size_t i);

/// Whether a clause of a comprehension (`for …`, `if …`) begins at piece `i`, which is not the first.
bool begins_clause(const std::vector<Piece>& pieces, std::size_t i);

/// Before its trailing comment, if any.
bool has_line_break_within(const FormatEntry& entry);

/// Normalises the line breaks of the text: a block with a break anywhere has one item per line, a list with one has its
/// brackets on lines of their own, and what follows a line comment begins a line.
void settle(Group& group);

/// Gives an entry that is too wide one more kind of line break; false if there is none left. `flat_width` measures a
/// group on a single line.
bool break_more(FormatEntry& entry, std::size_t (*flat_width)(Group&));

/// A line can begin with `-` or `{` only if a comma ends the item before it: marks the items that need one.
void mark_commas(std::vector<FormatEntry>& items);

/// Where the author has aligned the signs of consecutive items they stay aligned, as close as their names allow.
/// Returns the column of each item's sign, counted from the item's beginning; 0 if a single space will do.
std::vector<std::size_t> aligned_columns(const std::vector<FormatEntry>& items);

/// The same for trailing comments: how many extra spaces precede each. `widths` is the width of the line of each
/// comment, without the comment.
std::vector<std::size_t> comment_padding(const std::vector<FormatEntry>& items, const std::vector<std::size_t>& widths);

} // namespace rt::lang::layout
