#pragma once

#include "lang/check/files.hpp"
#include "lang/check/program.hpp"
#include "lang/diagnostics/report.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt::lang {

/// What the parts of check share while they process one file and those that it includes.
struct CheckContext {
  Program& program;
  Files& files;
  Report& report;
  std::vector<std::string>& open_files; ///< canonical paths of the files being read, to detect cycles
  const ModuleInfo* module = nullptr;   ///< the used file being read, null for the scene itself

  std::string_view name(Symbol symbol) const { return program.symbols.name(symbol); }
  std::uint32_t line(Span span) const { return program.sources.position(span.file, span.begin).line; }
  std::string_view text(Span span) const { return program.sources.text(span); }
};

} // namespace rt::lang
