#pragma once

#include "tools/repl/line_editor.hpp"

#include <cstddef>
#include <string_view>

namespace rt::tools {

class Shell;

/// The completions at the cursor: commands and their arguments after a colon, else whatever the language and the
/// session's names allow there.
Completion complete(Shell& shell, std::string_view text, std::size_t cursor);

/// The files and folders (with a slash) whose path begins with `start`, as it would be written; relative ones are in
/// the folder `base`.
std::vector<std::string> complete_path(std::string_view start, const std::string& base);

} // namespace rt::tools
