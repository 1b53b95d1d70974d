#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rt::tools {

/// The text with its lines broken at spaces if they are wider than `columns`. Continuations are indented to where the
/// line's second column begins (after the first two spaces within it), else by two more than the line.
std::string wrapped(std::string_view text, std::size_t columns);

} // namespace rt::tools
