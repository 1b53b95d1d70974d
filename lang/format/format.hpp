#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>
#include <vector>

namespace rt::lang {

/// A scene's text in the standard layout: two spaces per open bracket, one item per line if a block has several lines
/// or would be longer than 100 columns, comments and single blank lines kept. Its meaning is unchanged (`equal` trees),
/// and formatting is idempotent.
struct Formatted {
  std::string text;                    ///< the original text if it has syntax errors
  std::vector<Diagnostic> diagnostics; ///< the syntax errors
};
Formatted format(const SourceMap& sources, FileId file);

} // namespace rt::lang
