#pragma once

#include <string_view>

namespace rt::tools {

/// Writes all of it to standard output at once. Throws std::system_error.
void print(std::string_view text);
/// Writes to standard error; a failure is ignored: there is nowhere to report it.
void print_error(std::string_view text) noexcept;

bool error_is_terminal();
/// What TERM names knows colours (a vt100 does not), and NO_COLOR is not set (see no-color.org).
bool terminal_takes_color();
/// Standard error is a terminal that takes them.
bool error_takes_color();
/// The same for standard output.
bool output_takes_color();

} // namespace rt::tools
