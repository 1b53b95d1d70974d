#pragma once

#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"
#include "lang/text/file_system.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rt::lang {

struct AnalyseOptions {
  std::vector<std::pair<std::string, std::string>> defines; ///< -D name=value, the value as the text of an expression
  std::vector<std::string> include_roots; ///< folders besides the scene's own that `include` and `use` may read from
  const FileSystem* files = &disk();
  bool lint = false;             ///< also look for what is valid but probably not intended: `Report::remarks`
  bool keeps_references = false; ///< `Program::references`, for every item, even repeated ones
};

/// What a scene's texts say, before anything is evaluated. A text with errors has all this too: what could be parsed is
/// in the tree, and names are resolved as far as possible.
struct Analysis {
  std::unique_ptr<Program> program; ///< trees, what their names refer to, sources; on the heap, since parts point to it
  Report report;
  double parse_seconds = 0, check_seconds = 0;
  std::uint64_t bytes = 0;
};

/// Parses and checks. A file that cannot be read is an exception (std::system_error) for the scene itself, a diagnostic
/// for an include.
Analysis analyse_file(const std::string& path, const AnalyseOptions& options);
/// The same for a text that is not a file; relative includes are resolved against `folder`.
Analysis analyse_text(std::string text, std::string name, const std::string& folder, const AnalyseOptions& options);

} // namespace rt::lang
