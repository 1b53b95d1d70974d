#pragma once

#include "lang/diagnostics/diagnostic.hpp"

#include <string>
#include <vector>

namespace rt::lang {

/// A scene's text in the house's layout: two spaces for each open bracket, one item a line where a block has several
/// lines or would be longer than 100 columns, comments and single blank lines kept. It says what the text said (`equal`
/// trees), and formatting it again changes nothing.
struct Formatted {
  std::string text;                    ///< the text as it was, if it has syntax errors
  std::vector<Diagnostic> diagnostics; ///< the syntax errors
};
Formatted format(const SourceMap& sources, FileId file);

} // namespace rt::lang
