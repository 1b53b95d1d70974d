#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// How text stands on a terminal.
namespace rt::tools {

/// The spaces to begin a new row with after `text`: two for every bracket that is open.
std::string indentation_after(std::string_view text);

/// How many rows of the screen stand above the cursor behind `text`, whose first row begins in `column` (0 for the
/// screen's left) of a terminal with that many columns.
int rows_above(std::string_view text, int column, int columns);

/// How the words are laid out in columns for a terminal of that width; ends with a newline.
std::string in_columns(const std::vector<std::string>& words, std::size_t width);

/// `text` as it may be written to a terminal: without control characters but newlines.
std::string printable(std::string_view text);

} // namespace rt::tools
