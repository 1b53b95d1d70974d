#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rt::tools::lsp {

/// A range of bytes of a text, and its replacement.
struct Edit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

/// Few edits of whole lines that turn `before` into `after`, so that an editor's cursor and marks stay where they are.
std::vector<Edit> line_edits(std::string_view before, std::string_view after);

} // namespace rt::tools::lsp
