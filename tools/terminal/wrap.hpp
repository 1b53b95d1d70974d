#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rt::tools {

/// The text with its lines broken at spaces where they are wider than `columns`. What goes on is set in to where the
/// line's second column begins (behind the first two spaces within it), else two further than the line.
std::string wrapped(std::string_view text, std::size_t columns);

} // namespace rt::tools
