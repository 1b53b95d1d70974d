#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The layout of text on a terminal.
namespace rt::tools {

/// The indentation of a new row after `text`: two spaces for every open bracket.
std::string indentation_after(std::string_view text);

/// How many rows of the screen are above the cursor after `text`, whose first row begins in `column` (0 for the left
/// edge) of a terminal with that many columns.
int rows_above(std::string_view text, int column, int columns);

/// The words laid out in columns for a terminal of that width; ends with a newline.
std::string in_columns(const std::vector<std::string>& words, std::size_t width);

/// `text` made safe for a terminal: without control characters except newlines.
std::string printable(std::string_view text);

} // namespace rt::tools
