#pragma once

#include "lang/ide/reference.hpp"
#include "tools/lsp/diagnostics.hpp"
#include "tools/lsp/workspace.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace rt::tools::lsp {

/// Requests about the open texts. Each function takes the request's `params` and returns its `result`; it throws
/// RequestError, or nlohmann::json::exception for malformed params.
class Answers {
public:
  explicit Answers(Workspace& workspace);
  void set_encoding(PositionEncoding encoding) { encoding_ = encoding; }
  PositionEncoding encoding() const { return encoding_; }

  nlohmann::json hover(const nlohmann::json& params);
  nlohmann::json definition(const nlohmann::json& params);
  nlohmann::json references(const nlohmann::json& params);
  nlohmann::json highlight(const nlohmann::json& params);
  nlohmann::json completion(const nlohmann::json& params);
  nlohmann::json resolve_completion(const nlohmann::json& item);
  nlohmann::json formatting(const nlohmann::json& params);
  nlohmann::json symbols(const nlohmann::json& params);
  nlohmann::json prepare_rename(const nlohmann::json& params);
  nlohmann::json rename(const nlohmann::json& params);

private:
  /// A place of a text, in the scene that it is part of.
  struct Asked {
    Document& document;
    DocumentPlace place;
    Ranges ranges;
    std::uint32_t offset;
    const lang::Program& program() const { return *place.analysis->program; }
  };
  Document& document(const nlohmann::json& params);
  Asked asked(const nlohmann::json& params);
  nlohmann::json path_completion(const Asked& asked, std::size_t begin) const;
  lang::Span renamable(const Asked& asked) const;
  void require_same_meaning(const Asked& asked, const std::vector<lang::Span>& places, const std::string& name);

  Workspace& workspace_;
  PositionEncoding encoding_ = PositionEncoding::utf16;
  std::map<std::string, lang::ReferenceEntry, std::less<>> entries_; // by name
};

} // namespace rt::tools::lsp
