#pragma once

#include "tools/lsp/workspace.hpp"

#include <nlohmann/json.hpp>

#include <atomic>
#include <map>
#include <optional>
#include <string>

namespace rt::tools::lsp {

/// Converts places of a scene's texts to the protocol's ranges and locations.
class Ranges {
public:
  Ranges(const Workspace& workspace, const lang::SourceMap& sources, PositionEncoding encoding)
      : workspace_(workspace), sources_(sources), encoding_(encoding) {}

  nlohmann::json range(lang::Span span);
  /// Nothing for a place in a text that is not a file: the library, the command line.
  std::optional<nlohmann::json> location(lang::Span span);
  std::size_t offset(lang::FileId file, TextPosition position) { return lines(file).offset(position, encoding_); }

private:
  const LineTable& lines(lang::FileId file);

  const Workspace& workspace_;
  const lang::SourceMap& sources_;
  PositionEncoding encoding_;
  std::map<lang::FileId, LineTable> lines_;
};

/// The diagnostics of all open scenes, by the URI of the text that they are about; an entry for each open document.
/// Nothing if `stop` was set meanwhile.
std::optional<std::map<std::string, nlohmann::json>> all_diagnostics(Workspace& workspace, PositionEncoding encoding,
                                                                     const std::atomic<bool>& stop);

} // namespace rt::tools::lsp
